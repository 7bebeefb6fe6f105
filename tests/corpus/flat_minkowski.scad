// Flat Minkowski sums: convex, not convex, of a ring, of three.
linear_extrude(3) minkowski() { square([8, 5]); circle(2); }
translate([16, 0]) linear_extrude(4) minkowski() {
  polygon([[0, 0], [10, 0], [10, 3], [3, 3], [3, 10], [0, 10]]);
  polygon([[0, 0], [2, 0], [0, 3]]);
}
translate([44, 6]) linear_extrude(5) minkowski() { difference() { circle(7); circle(4); } square(1.5, center = true); }
translate([0, 16]) linear_extrude(6) minkowski() { square(3); circle(1, $fn = 5); polygon([[0, 0], [4, 1], [0, 2]]); }
