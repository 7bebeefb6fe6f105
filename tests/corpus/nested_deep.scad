// From flat to solid and back several times.
difference() {
  linear_extrude(6, scale = 0.7) offset(r = 1, $fn = 12) projection(cut = true) translate([0, 0, -2])
    hull() { rotate_extrude($fn = 16) translate([5, 0]) circle(3, $fn = 8); translate([14, 0, 0]) linear_extrude(4) text("I", size = 9, font = "DejaVu Sans"); }
  translate([2, 0, 3]) linear_extrude(9) hull() projection() rotate([0, 90, 0]) cylinder(6, 3, 1, $fn = 8);
}
