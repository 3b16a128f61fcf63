// The dam break against an elastic barrier: fluid, walls and barrier. Lengths in m.
h = 0.006;
Point(1) = {0, 0, 0, h}; Point(2) = {0.146, 0, 0, h}; Point(3) = {0.146, 0.292, 0, h}; Point(4) = {0, 0.292, 0, h};
Point(5) = {0.292, 0, 0, 2*h}; Point(6) = {0.304, 0, 0, 2*h}; Point(7) = {0.304, 0.08, 0, 2*h}; Point(8) = {0.292, 0.08, 0, 2*h};
Point(9) = {0.8, 0, 0, h}; Point(10) = {0, 0.36, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Line(9) = {2, 5}; Line(10) = {6, 9}; Line(11) = {4, 10};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8}; Plane Surface(2) = {2};
Physical Surface("water") = {1}; Physical Surface("barrier") = {2};
Physical Curve("walls") = {1, 4, 9, 10, 11};
