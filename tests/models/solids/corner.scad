// The same in every format that meshes are read from.
difference() {
  cube([4, 3, 2]);
  translate([1.5, 1.25, -1]) cube(5);
}
