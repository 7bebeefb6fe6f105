// Three fragments; as many as $fa and $fs call for at the widest place; parts of a profile.
rotate_extrude($fn = 3) translate([2, 0]) square([4, 3]);
translate([16, 0, 0]) rotate_extrude($fa = 20, $fs = 0.5) translate([2, 0]) square([4, 3]);
translate([0, 16, 0]) rotate_extrude($fn = 7) { translate([1, 0]) square(2); translate([5, 2]) circle(1.5, $fn = 6); }
translate([16, 16, 0]) rotate_extrude(angle = 200, $fn = 5) translate([2, 0]) square([3, 4]);
