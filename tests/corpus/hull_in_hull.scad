// A hull in a hull, one of a single child, one with a flat child that is left out, one of nothing.
hull() { cube(2); translate([8, 0, 0]) hull() { sphere(1, $fn = 8); translate([0, 8, 0]) cube(1); } }
translate([14, 0, 0]) hull() difference() { cylinder(6, 4, 1, $fn = 7); cylinder(30, 1, 1, center = true); }
hull() { union() {} cube(0); }
translate([22, 0, 0]) hull() { cube(4); translate([0, 0, 8]) cube([1, 4, 1]); }
