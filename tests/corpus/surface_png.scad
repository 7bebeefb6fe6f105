// Heights from a picture, and upside down.
scale([1, 1, 0.1]) surface("data/hills.png");
translate([20, 6, 0]) scale([1, 1, 0.1]) surface("data/hills.png", center = true, invert = true);
