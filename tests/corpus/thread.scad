// A thread by twisting a circle off the axis, on a rod with a bevelled end and a slot.
difference() {
  intersection() {
    linear_extrude(height = 20, twist = -360 * 20 / 4, slices = 80) translate([0.8, 0]) circle(5, $fn = 20);
    union() { cylinder(18, 6, 6, $fn = 20); translate([0, 0, 18]) cylinder(2, 6, 4, $fn = 20); }
  }
  translate([-0.7, -9, 17.5]) cube([1.4, 18, 9]);
}
