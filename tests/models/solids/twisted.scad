linear_extrude(height = 20, twist = 60, slices = 8, scale = 1.4) difference() {
  circle(r = 20, $fn = 6);
  circle(r = 18, $fn = 6);
}
