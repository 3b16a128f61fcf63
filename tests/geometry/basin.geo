// Fluid, 1 m x 0.6 m x 0.5 m, on a floor of 1.6 m x 0.6 m and against a wall 0.8 m high, and beside it a block.
//
//   gmsh -3 -format msh22 -o basin_22.msh basin.geo
//   gmsh -3 -format msh41 -o basin_41.msh basin.geo
//   gmsh -3 -bin -format msh41 -o basin_41_binary.msh basin.geo
//   gmsh -3 -order 2 -bin -format msh22 -o basin_22_quadratic.msh basin.geo
h = 0.2;

Point(1) = {0, 0, 0, h};   Point(2) = {1, 0, 0, h};   Point(3) = {1, 0.6, 0, h};   Point(4) = {0, 0.6, 0, h};
Point(5) = {1.6, 0, 0, h}; Point(6) = {1.6, 0.6, 0, h};
Point(7) = {0, 0, 0.5, h}; Point(8) = {0, 0.6, 0.5, h};
Point(9) = {0, 0, 0.8, h}; Point(10) = {0, 0.6, 0.8, h};

Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {2, 5}; Line(6) = {5, 6}; Line(7) = {6, 3};
Line(8) = {1, 7}; Line(9) = {7, 8}; Line(10) = {8, 4};
Line(11) = {7, 9}; Line(12) = {9, 10}; Line(13) = {10, 8};

Curve Loop(1) = {1, 2, 3, 4};    Plane Surface(1) = {1}; // floor below the fluid
Curve Loop(2) = {5, 6, 7, -2};   Plane Surface(2) = {2}; // and beyond it
Curve Loop(3) = {8, 9, 10, 4};   Plane Surface(3) = {3}; // wall beside the fluid
Curve Loop(4) = {11, 12, 13, -9}; Plane Surface(4) = {4}; // and above it

Point(11) = {1, 0, 0.5, h}; Point(12) = {1, 0.6, 0.5, h};
Line(14) = {2, 11}; Line(15) = {3, 12}; Line(16) = {7, 11}; Line(17) = {8, 12}; Line(18) = {11, 12};
Curve Loop(5) = {1, 14, -16, -8};   Plane Surface(5) = {5};
Curve Loop(6) = {3, -10, 17, -15};  Plane Surface(6) = {6};
Curve Loop(7) = {2, 15, -18, -14};  Plane Surface(7) = {7};
Curve Loop(8) = {16, 18, -17, -9};  Plane Surface(8) = {8};
Surface Loop(1) = {1, 3, 5, 6, 7, 8};
Volume(1) = {1};

Point(21) = {1.3, 0.2, 0.1, h};
Point(22) = {1.5, 0.2, 0.1, h};
Point(23) = {1.5, 0.4, 0.1, h};
Point(24) = {1.3, 0.4, 0.1, h};
Line(21) = {21, 22}; Line(22) = {22, 23}; Line(23) = {23, 24}; Line(24) = {24, 21};
Curve Loop(21) = {21, 22, 23, 24}; Plane Surface(21) = {21};
block[] = Extrude {0, 0, 0.4} { Surface{21}; };

Physical Volume("fluid") = {1};
Physical Volume("block") = {block[1]};
Physical Surface("floor") = {1, 2};
Physical Surface("left wall") = {3, 4};
Physical Surface("walls") = {1, 2, 3, 4};
