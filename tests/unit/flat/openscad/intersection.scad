intersection() {
  circle(r = 10, $fn = 48);
  translate([3, 0]) circle(r = 10, $fn = 31);
  translate([0, -4]) square([20, 9], center = true);
}
