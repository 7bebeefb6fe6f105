// Minkowski sum of two solids that are not convex: a union of an L and a block apart, and a cross.
minkowski() {
  union() {
    difference() { cube([10, 8, 3]); translate([4, 3, -1]) cube([10, 10, 5]); }
    translate([14, 2, 1]) rotate([20, 10, 0]) cube(2);
  }
  union() { cube([2, 0.5, 1], center = true); rotate(90) cube([3, 0.5, 0.5], center = true); }
  sphere(r = 0.5, $fn = 8);
}
