resize([0, 7]) square([3, 2], center = true);
