// An STL file of two shells, one in the other: a box with a hollow, cut open.
difference() {
  import("data/hollow.stl");
  translate([-1, -1, 5]) cube([8, 20, 20]);
}
