// Many thin bars across a frame.
intersection() {
  union() for (i = [-4:4]) { translate([i * 4, 0, 0]) rotate([0, 0, 40]) cube([0.8, 60, 2], center = true); translate([i * 4, 0, 1]) rotate([0, 0, -40]) cube([0.8, 60, 2], center = true); }
  linear_extrude(6, center = true) circle(14, $fn = 40);
}
linear_extrude(6, center = true) difference() { circle(15, $fn = 40); circle(13, $fn = 40); }
