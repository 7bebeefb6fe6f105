// Flattened by a singular matrix: nothing is left, and nothing is taken away.
difference() {
  linear_extrude(5) square(10);
  scale([1, 1, 0]) linear_extrude(20) circle(4);
  multmatrix([[1, 0, 0, 0], [0, 0, 0, 0], [0, 0, 1, 0]]) hull() { cube(3); translate([5, 0, 0]) sphere(3); }
}
scale([0, 1, 1]) rotate_extrude() square(20);
