// A rounded box by a hull of cylinders, one of cones, one of extrusions: faces of many corners in one plane.
hull() for (x = [0, 14], y = [0, 9]) translate([x, y, 0]) cylinder(5, 2, 2, $fn = 16);
translate([24, 0, 0]) hull() { cylinder(3, 4, 2, $fn = 9); translate([8, 5, 2]) linear_extrude(4) square([3, 6]); }
