// Sums of three, of an extrusion, with an empty operand.
minkowski() { cube([8, 3, 2]); cylinder(1, 2, 2, $fn = 8); cube([1, 1, 5]); }
translate([20, 0, 0]) minkowski() {
  linear_extrude(2) polygon([[0, 0], [8, 0], [3, 3], [0, 8]]);
  sphere(1, $fn = 6);
}
translate([0, 12, 0]) minkowski() { cube(4); union() {} }
