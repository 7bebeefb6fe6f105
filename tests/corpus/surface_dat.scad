// Heights from a text file; with its base a unit below the least of them.
surface("data/hills.dat");
translate([24, 5, 0]) scale([0.6, 1.2, 1.5]) surface("data/hills.dat", center = true, convexity = 5);
