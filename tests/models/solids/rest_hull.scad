// The hull of what a difference and an intersection leave.
hull() {
  difference() { cube([10, 8, 6]); translate([5, 4, 3]) cube(10); rotate([0, 30, 0]) cube([30, 30, 2], center = true); }
  intersection() { translate([0, 0, 8]) sphere(r = 3, $fn = 12); translate([-5, -5, 8]) cube(9); }
}
