// A polygon without paths, clockwise, with collinear and repeated corners; and one that is not convex.
linear_extrude(3) polygon([[0, 0], [0, 4], [0, 8], [5, 8], [10, 8], [10, 8], [10, 0], [5, 3]]);
translate([14, 0]) linear_extrude(5)
  polygon([[0, 0], [9, 0], [9, 2], [2, 2], [2, 4], [9, 4], [9, 9], [0, 9], [0, 7], [7, 7], [7, 6], [0, 6]]);
