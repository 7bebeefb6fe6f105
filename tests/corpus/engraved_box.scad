// A box with a name engraved in its lid and one raised on its front.
difference() {
  cube([44, 24, 8]);
  translate([22, 12, 7]) linear_extrude(3) text("csgsim", size = 9, font = "DejaVu Sans:style=Bold", halign = "center", valign = "center");
}
translate([22, 0, 4]) rotate([90, 0, 0]) linear_extrude(1) text("No. 14", size = 4, font = "DejaVu Serif", halign = "center", valign = "center");
