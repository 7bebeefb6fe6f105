module tooth() polygon([[0, -2], [3, -1.8], [4.5, -0.8], [4.5, 0.8], [3, 1.8], [0, 2]]);

linear_extrude(5) difference() {
  union() {
    circle(r = 12, $fn = 24);
    for (i = [0 : 11]) rotate(i * 30) translate([11, 0]) tooth();
  }
  circle(r = 5, $fn = 12);
}
