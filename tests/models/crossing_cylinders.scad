// Two cylinders that cross, in the place of those of the thesis's plate 3, whose measures are not published.
// With $fn = 12, 18, 24 and 32 they have as many segments as fit the thesis's 96, 144, 192 and 256 polygons at four a
// segment of each cylinder.
union() {
  rotate([0, 90, 0]) cylinder(h = 200, r = 50, center = true, $fn = 32);
  translate([0, 0, 20]) rotate([90, 0, 0]) cylinder(h = 200, r = 50, center = true, $fn = 32);
}
