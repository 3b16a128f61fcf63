// The channel of pier_in_a_channel.prm, 1 m long and 0.4 m wide, and the hole in it for a pier of 0.1 m.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 1, 0.4};
Disk(2) = {0.4, 0.2, 0, 0.05};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
pier() = Curve In BoundingBox {0.34, 0.14, -1, 0.46, 0.26, 1};
Physical Surface("mud") = {3};
Physical Curve("pier") = pier();
