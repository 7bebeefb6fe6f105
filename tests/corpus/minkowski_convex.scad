// Sums of convex solids: a rounded box, a box with a round rim, a sum of one.
minkowski() { cube([10, 6, 3]); sphere(1.5, $fn = 12); }
translate([18, 0, 0]) minkowski() { cube([8, 8, 2]); cylinder(2, 2, 0, $fn = 14); }
translate([34, 0, 0]) minkowski() { cube([4, 4, 9]); }
