// A 3MF file, less a hole.
difference() {
  import("data/star.3mf");
  cylinder(30, 3, 3, center = true);
}
