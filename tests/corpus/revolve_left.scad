// A profile on the other side of the axis, and one part of the way around there.
rotate_extrude($fn = 16) translate([-5, 0]) square([3, 6]);
translate([12, 0, 0]) rotate_extrude(angle = 100, $fn = 16) translate([-5, 0]) polygon([[0, 0], [3, 0], [0, 6]]);
