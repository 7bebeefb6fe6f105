// Twisted backwards, with holes and in several parts; each slice bends the same way.
linear_extrude(height = 15, twist = -120, slices = 8) {
  difference() { square([12, 6], center = true); translate([3, 0]) circle(1.5, $fn = 8); }
  translate([0, 8]) circle(2, $fn = 10);
}
