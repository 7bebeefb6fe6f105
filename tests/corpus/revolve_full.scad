// rotate_extrude all around: beside the axis, along the axis, with a hole in the profile.
rotate_extrude($fn = 24) translate([6, 0]) circle(2, $fn = 10);
translate([18, 0, 0]) rotate_extrude($fn = 24) polygon([[0, 0], [6, 0], [6, 2], [2, 3], [2, 8], [4, 10], [0, 10]]);
translate([34, 0, 0]) rotate_extrude() translate([4, 0]) difference() { square([4, 6]); translate([1, 1]) square([2, 4]); }
