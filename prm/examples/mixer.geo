// The tank of mixer.prm, radius 0.1 m, and in it a cross of paddles 0.12 m across and 12 mm thick.
SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 0.1};
Rectangle(2) = {-0.06, -0.006, 0, 0.12, 0.012};
Rectangle(3) = {-0.006, -0.06, 0, 0.012, 0.12};
BooleanDifference(4) = { Surface{1}; Delete; }{ Surface{2, 3}; Delete; };
paddle() = Curve In BoundingBox {-0.07, -0.07, -1, 0.07, 0.07, 1};
tank() = Boundary{ Surface{4}; };
tank() -= paddle();
Physical Surface("mud") = {4};
Physical Curve("tank") = tank();
Physical Curve("paddle") = paddle();
