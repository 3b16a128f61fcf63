// column.geo with a group whose name has a comma and one without a name.
//
//   gmsh -2 -format msh41 -o groups_41.msh groups.geo
Include "column.geo";

Physical Surface("water, at rest") = {1};
Physical Curve(7) = {1, 5};
