// Sums of a solid that is not convex: of an angle, of a ring, whose holes grow smaller.
minkowski() {
  difference() { cube([12, 10, 4]); translate([4, 4, -1]) cube(20); }
  sphere(1, $fn = 8);
}
translate([24, 5, 0]) minkowski() {
  difference() { cube([12, 12, 3], center = true); cube([5, 5, 9], center = true); }
  cylinder(2, 1, 0, $fn = 6);
}
