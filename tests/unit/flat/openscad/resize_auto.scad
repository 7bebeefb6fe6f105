resize([12, 0], auto = true) square([3, 2]);
