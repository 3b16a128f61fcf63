// A sphere of radius 1 m.
//
//   gmsh -3 -format msh41 sphere.geo
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 1};
MeshSize{ PointsOf{ Volume{1}; } } = 0.25;
Mesh.MeshSizeFromPoints = 1;
Mesh.MeshSizeMin = 0.25;
Mesh.MeshSizeMax = 0.25;
Physical Volume("drop") = {1};
