// Flat hulls: of circles, of a shape that is not convex, of one with a hole, of nothing and a square.
linear_extrude(3) hull() { circle(4); translate([14, 3]) circle(2); translate([5, 12]) square(1); }
translate([24, 0]) linear_extrude(4) hull() polygon([[0, 0], [10, 0], [2, 2], [0, 10], [-3, 5]]);
translate([42, 4]) linear_extrude(5) hull() difference() { circle(6, $fn = 9); circle(4); }
translate([0, 20]) linear_extrude(6) hull() { square([6, 3]); square(0); union() {} }
