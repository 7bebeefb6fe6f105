minkowski() {
  difference() {
    square([20, 12]);
    translate([3, 3]) square([12, 6]);
  }
  circle(r = 1, $fn = 16);
}
