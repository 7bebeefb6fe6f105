// linear_extrude: up from the plane, about the plane, of nothing; a shape of several parts with holes.
module parts() { difference() { circle(6); circle(3); } translate([8, -2]) square([3, 9]); }
linear_extrude(height = 4) parts();
translate([0, 18, 0]) linear_extrude(height = 4, center = true) parts();
linear_extrude(height = 40) union() {}
