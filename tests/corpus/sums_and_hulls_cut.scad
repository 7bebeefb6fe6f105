// A hull less a sum less a turned profile, and an intersection of three kinds.
difference() {
  hull() { cylinder(8, 8, 6, $fn = 20); translate([14, 0, 0]) cylinder(5, 4, 4, $fn = 16); }
  translate([12, -2, 2]) minkowski() { cube([4, 4, 9]); sphere(1, $fn = 8); }
  translate([0, 0, 8]) rotate_extrude($fn = 20) translate([4, 0]) circle(2, $fn = 10);
}
translate([28, 0, 0]) intersection() {
  linear_extrude(12, twist = 90, slices = 10) square(10, center = true);
  rotate_extrude($fn = 20) polygon([[0, 0], [7, 2], [3, 6], [7, 10], [0, 12]]);
  translate([0, 0, 6]) cube([20, 8, 20], center = true);
}
