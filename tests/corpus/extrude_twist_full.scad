// A full turn up to a point: twist 360, scale 0 at the top.
linear_extrude(height = 24, twist = 360, scale = 0, slices = 30) difference() {
  square(12, center = true);
  translate([2, 2]) circle(2, $fn = 12);
}
