// Resized within a resize, and a mesh resized.
resize([20, 10, 5]) { resize([5, 5, 5]) sphere(9, $fn = 10); translate([6, 0, 0]) cube(4); }
translate([24, 0, 0]) resize([12, 0, 4], auto = [false, true, false]) import("data/star.stl");
