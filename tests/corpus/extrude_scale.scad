// Scaled up, down, by a vector, to a line and to a point, without a twist.
linear_extrude(height = 8, scale = 2) square(4, center = true);
translate([14, 0, 0]) linear_extrude(height = 8, scale = [2, 0.5]) square(4, center = true);
translate([26, 0, 0]) linear_extrude(height = 8, scale = [0, 1]) square(6, center = true);
translate([0, 14, 0]) linear_extrude(height = 8, scale = 0) circle(4, $fn = 7);
translate([14, 14, 0]) linear_extrude(height = 8, scale = 0.3, center = true) polygon([[0, 0], [8, 0], [8, 3], [3, 3], [3, 8], [0, 8]]);
translate([30, 14, 0]) linear_extrude(height = 8, scale = [1.5, 0]) translate([1, 0]) square([3, 6], center = true);
