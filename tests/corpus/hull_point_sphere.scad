// The hull of a sphere and of a cube so small that it is a point.
hull() {
  sphere(5, $fn = 16);
  translate([14, 3, 6]) cube(0.001);
}
