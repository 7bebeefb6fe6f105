// Sums of two solids neither of which is convex: two angles, and a cross with a hollow corner.
minkowski() {
  difference() { cube([10, 8, 3]); translate([3, 3, -1]) cube(20); }
  difference() { cube([3, 3, 2]); translate([1, 1, -1]) cube(9); }
}
translate([20, 4, 0]) minkowski() {
  union() { cube([10, 2, 2], center = true); cube([2, 10, 2], center = true); }
  linear_extrude(1.5) polygon([[0, 0], [3, 0], [1, 1], [0, 3]]);
}
