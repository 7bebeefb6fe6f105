difference() {
  sphere(r = 10, $fn = 24);
  translate([6, 0, 3]) sphere(r = 7, $fn = 20);
}
