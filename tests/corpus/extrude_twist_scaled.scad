// Twisted and scaled by a vector at once, about the plane.
linear_extrude(height = 20, twist = 200, scale = [0.3, 1.4], center = true, slices = 25)
  polygon([[0, 0], [9, 0], [9, 3], [3, 3], [3, 9], [0, 9]]);
