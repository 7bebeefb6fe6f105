// Text as it comes: several contours a letter, holes in them, a space.
linear_extrude(3) text("csg 8B&%", size = 10, font = "DejaVu Sans");
