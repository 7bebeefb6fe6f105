// Part of the way around, forwards, backwards, and as far as all around.
rotate_extrude(angle = 90, $fn = 24) translate([3, 0]) square([4, 5]);
translate([14, 0, 0]) rotate_extrude(angle = -135, $fn = 24) translate([3, 0]) circle(2, $fn = 8);
translate([0, 18, 0]) rotate_extrude(angle = 270) polygon([[0, 0], [5, 0], [0, 9]]);
translate([18, 18, 0]) rotate_extrude(angle = 400, $fn = 16) translate([4, 0]) square(2);
translate([30, 0, 0]) rotate_extrude(angle = 5, $fn = 8) square([9, 6]);
