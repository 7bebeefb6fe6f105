square([3, 2]);
