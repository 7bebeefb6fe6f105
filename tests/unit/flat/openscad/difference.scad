difference() {
  circle(r = 10, $fn = 48);
  square([6, 6]);
  translate([-4, -3]) circle(r = 2, $fn = 12);
}
