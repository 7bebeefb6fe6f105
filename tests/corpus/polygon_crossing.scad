// Polygons that cross or touch themselves: a bow tie, a pentagram, paths that overlap, a path that touches itself.
// (One extrusion alone: OpenSCAD cannot take corners that touch into a union of solids.)
linear_extrude(5) {
  polygon([[0, 0], [10, 8], [10, 0], [0, 8]]);
  translate([20, 4]) polygon([for (i = [0:4]) 6 * [cos(144 * i), sin(144 * i)]]);
  translate([0, 12]) polygon([[0, 0], [8, 0], [8, 8], [0, 8], [4, 3], [12, 3], [12, 6], [4, 6]], [[0, 1, 2, 3], [4, 5, 6, 7]]);
  translate([16, 12]) polygon([[0, 0], [10, 0], [10, 8], [5, 0], [0, 8]]);
}
