// A pyramid from an extrusion, a wedge and a roof: planes that meet in a point and along a ridge.
linear_extrude(7, scale = 0) square(10, center = true);
translate([14, 0, 0]) linear_extrude(7, scale = [1, 0]) square(10, center = true);
translate([28, 0, 0]) linear_extrude(7, scale = [0.5, 0]) square([10, 6], center = true);
