offset(r = -1.5, $fn = 40) difference() {
  circle(r = 10, $fn = 60);
  translate([2, 1]) square(3);
}
