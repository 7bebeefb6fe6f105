// Union, difference and intersection of flat shapes, in one another.
linear_extrude(5) difference() {
  union() {
    square([24, 12]);
    translate([12, 12]) circle(8);
    translate([4, 11]) rotate(30) square(6, center = true);
  }
  translate([12, 12]) difference() {
    circle(5);
    square(4, center = true);
  }
  intersection() {
    translate([5, 5]) circle(4);
    square([5, 20]);
    translate([0, 2]) square(30);
  }
}
