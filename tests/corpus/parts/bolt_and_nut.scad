// A bolt with a hexagonal head, a threaded shank with a bevelled end, a washer and a nut that is threaded inside.
pitch = 3;
steps = 24;  // slices a turn

// A thread by turning a disc whose middle is off the axis: its section is round all the way up.
module thread(radius, depth, length) {
  linear_extrude(height = length, twist = -360 * length / pitch, slices = steps * length / pitch)
    translate([depth / 2, 0]) circle(radius - depth / 2, $fn = 32);
}

module hexagon(across, height) {
  intersection() {
    cylinder(h = height, r = across / sqrt(3), $fn = 6);
    // the corners are turned off
    rotate_extrude($fn = 48) polygon([[0, 0], [across * 0.55, 0], [across * 0.6, 1], [across * 0.6, height - 1], [across * 0.55, height], [0, height]]);
  }
}

color("silver") {
  difference() {
    hexagon(18, 8);
    translate([0, 0, -0.01]) linear_extrude(0.6) mirror([1, 0]) text("8.8", size = 5, font = "DejaVu Sans:style=Bold", halign = "center", valign = "center");
  }
  translate([0, 0, 7.5]) cylinder(h = 10.5, r = 6, $fn = 40);
  intersection() {
    translate([0, 0, 17]) thread(6, 1.4, 33);
    translate([0, 0, 17]) union() { cylinder(h = 31, r = 7, $fn = 40); translate([0, 0, 31]) cylinder(h = 2, r1 = 6, r2 = 4.6, $fn = 40); }
  }
}
color("goldenrod") translate([24, 0, 0]) difference() {
  hexagon(18, 10);
  translate([0, 0, -1]) thread(6.3, 1.4, 12);
  translate([0, 0, 8.8]) cylinder(h = 1.21, r1 = 5.2, r2 = 6.6, $fn = 40);
  translate([0, 0, -0.01]) cylinder(h = 1.21, r1 = 6.6, r2 = 5.2, $fn = 40);
}
color("lightgray") translate([24, 0, -3]) linear_extrude(2) difference() { circle(11, $fn = 48); circle(6.5, $fn = 40); }
