// A column of fluid, 0.146 m x 0.292 m, on a floor of 0.5 m and against a wall of 0.4 m: the walls go on beyond the fluid,
// so not all of their edges are edges of the fluid. Group "walls" shares its curves with "floor" and "left wall".
//
//   gmsh -2 -format msh22 -o column_22.msh column.geo
//   gmsh -2 -format msh41 -o column_41.msh column.geo
//   gmsh -2 -format msh40 -o column_40.msh column.geo
//   gmsh -2 -bin -format msh22 -o column_22_binary.msh column.geo
//   gmsh -2 -bin -format msh41 -o column_41_binary.msh column.geo
//   gmsh -2 -order 2 -format msh41 -o column_41_quadratic.msh column.geo
h = 0.03;

Point(1) = {0, 0, 0, h};
Point(2) = {0.146, 0, 0, h};
Point(3) = {0.146, 0.292, 0, h};
Point(4) = {0, 0.292, 0, h};
Point(5) = {0.5, 0, 0, h};
Point(6) = {0, 0.4, 0, h};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {2, 5};
Line(6) = {6, 4};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Physical Surface("fluid") = {1};
Physical Curve("floor") = {1, 5};
Physical Curve("left wall") = {4, 6};
Physical Curve("walls") = {1, 4, 5, 6};
