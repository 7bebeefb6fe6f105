difference() { cube([20, 12, 8]); translate([14, 6, -1]) cylinder(r = 3, h = 12, $fn = 24); }
translate([2, 3, 8]) cube([4, 5, 10]);
translate([-6, 0, 0]) rotate([0, 20, 0]) cube([3, 3, 14]);
