// Mirrored, sheared and unevenly scaled: extrusions, profiles turned, hulls, polyhedra and text.
multmatrix([[-1, 0, 0.3, 0], [0, 1.5, 0, 0], [0.2, 0, 1, 0]]) linear_extrude(6, twist = 45, slices = 4) square([8, 4]);
mirror([1, 0, 0]) translate([-14, 0, 0]) rotate_extrude(angle = 120, $fn = 20) translate([2, 0]) square([5, 3]);
translate([0, 16, 0]) scale([1, -2, 0.5]) hull() { sphere(3, $fn = 10); translate([6, 0, 4]) cube(2); }
translate([14, 14, 0]) mirror([0, 1, 0]) scale([1, 1, -3]) linear_extrude(1) text("R", font = "DejaVu Sans");
translate([30, 6, 0]) multmatrix([[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]]) import("data/angle.off");
