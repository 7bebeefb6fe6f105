// A vase: a flower of eight petals, extruded with a twist, first wider and then narrower; hollow, on a foot.
petals = 8;
module flower(r) {
  polygon([for (i = [0:95]) let (a = 360 * i / 96) (r + 3 * cos(petals * a)) * [cos(a), sin(a)]]);
}
module body(r) {
  linear_extrude(height = 50, twist = 60, scale = 1.45, slices = 20) flower(r);
  translate([0, 0, 50]) rotate(-60) linear_extrude(height = 30, twist = -50, scale = 0.6, slices = 14) scale(1.45) flower(r);
}
color("teal") difference() {
  body(20);
  difference() {
    union() { body(18); translate([0, 0, 79.9]) cylinder(h = 2, r = 15); }
    cylinder(h = 3, r = 40);
  }
}
color("darkcyan") rotate_extrude($fn = 64) polygon([[12, -4], [25, -4], [24, -1], [20, 1], [12, 1]]);
