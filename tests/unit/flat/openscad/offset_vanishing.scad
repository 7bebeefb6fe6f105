offset(delta = -2) square([10, 4.5]);
