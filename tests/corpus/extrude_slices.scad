// Twisted by a quarter in one slice, in three, and in as many as OpenSCAD takes.
linear_extrude(height = 10, twist = 90, slices = 1) square([8, 4], center = true);
translate([14, 0, 0]) linear_extrude(height = 10, twist = 90, slices = 3) square([8, 4], center = true);
translate([28, 0, 0]) linear_extrude(height = 10, twist = 90) square([8, 4], center = true);
translate([42, 0, 0]) linear_extrude(height = 10, twist = 90, $fn = 40) square([8, 4], center = true);
