// Imported meshes in differences and intersections with extrusions and with one another.
difference() {
  import("data/star.stl");
  translate([0, 0, 4]) linear_extrude(9) text("S", size = 6, font = "DejaVu Sans", halign = "center", valign = "center");
  translate([9, 1, 3.2]) rotate(7) import("data/torus.stl");
}
translate([26, 0, 0]) intersection() {
  import("data/torus.stl");
  translate([4, 0, -3]) import("data/star.stl");
}
