// Cut by the x, y plane.
projection(cut = true) { rotate([30, 20, 0]) difference() { cube([10, 8, 6]); translate([2, 2, -1]) cube([3, 3, 20]); } translate([15, 0, 0]) sphere(r = 3, $fn = 16); }
