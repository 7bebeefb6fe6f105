// Curves of an SVG file, in coarse and in fine pieces, moved to the middle; its units are half a millimetre.
linear_extrude(2) import("data/curves.svg", $fn = 6);
translate([60, 15]) linear_extrude(3) import("data/curves.svg", $fn = 40, center = true);
