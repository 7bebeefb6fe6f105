// Spheres and cones of the old nodes among the new ones.
difference() {
  sphere(8, $fn = 24);
  linear_extrude(20) circle(3, $fn = 16);
  rotate([90, 0, 0]) linear_extrude(20) text("o", size = 8, font = "DejaVu Sans", halign = "center", valign = "center");
}
translate([18, 0, 0]) intersection() { cylinder(9, 8, 2, $fn = 20); linear_extrude(9) offset(r = 2, $fn = 8) square([12, 3], center = true); }
