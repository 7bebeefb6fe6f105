// A ball in a void in a block.
difference() {
  cube(20, center = true);
  sphere(r = 8, $fn = 12);
}
sphere(r = 5, $fn = 10);
