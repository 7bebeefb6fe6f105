square([3, 2.5], center = true);
