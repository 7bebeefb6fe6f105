// A knob with a knurled grip, a flat pointer, a skirt with its numbers, and a hole for a shaft with a flat.
module skirt() {
  rotate_extrude($fn = 72) polygon([[0, 0], [21, 0], [21, 1.5], [14, 5], [0, 5]]);
}
module grip() {
  difference() {
    rotate_extrude($fn = 60) polygon([[0, 4], [12, 4], [12, 18], [11, 19.5], [0, 20.5]]);
    for (i = [0:23], s = [-1, 1]) rotate(15 * i) translate([0, 0, 5])
      linear_extrude(height = 12.5, twist = 30 * s, slices = 6) translate([12.2, 0]) rotate(45) square(1.1, center = true);
  }
}
color([0.35, 0.36, 0.4]) difference() {
  union() { skirt(); grip(); }
  translate([0, 0, -1]) linear_extrude(13) intersection() { circle(3.05, $fn = 32); translate([-4, -4]) square([8, 5.5]); }
  translate([3, -0.6, 19]) cube([7, 1.2, 4]);
}
// The numbers stand on the slope of the skirt.
color("white") for (i = [0:9]) rotate(150 - 33.3 * i) translate([17.3, 0, 3.1]) rotate([0, 27, 0]) rotate(-90)
  linear_extrude(0.8, center = true) text(str(i), size = 3.2, font = "DejaVu Sans:style=Bold", halign = "center", valign = "center");
