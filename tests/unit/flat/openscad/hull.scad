hull() {
  circle(r = 3, $fn = 20);
  translate([10, 4]) square(2);
  translate([5, 1]) square(1);
}
