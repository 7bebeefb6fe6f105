// Hulls of what has been cut: a corner cut off stays off, a hole is filled.
hull() {
  difference() { cube(10); translate([5, 5, 5]) cube(10); rotate([0, 0, 45]) cube([6, 6, 30], center = true); }
  translate([16, 2, 2]) intersection() { sphere(4, $fn = 12); cube(9, center = true); }
}
