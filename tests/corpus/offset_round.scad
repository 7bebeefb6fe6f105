// offset by r: corners outward are round, corners inward are not; the other way round inside.
module shape() { polygon([[0, 0], [14, 0], [14, 4], [6, 4], [6, 12], [10, 12], [3, 17], [0, 12]]); }
linear_extrude(2) offset(r = 2) shape();
linear_extrude(4) shape();
translate([24, 0]) linear_extrude(3) offset(r = 1.5, $fn = 24) shape();
translate([48, 0]) linear_extrude(3) offset(r = -1.2) shape();
translate([48, 0]) linear_extrude(1) shape();
