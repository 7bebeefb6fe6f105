// Faces that are not convex, of seven corners, and faces with collinear corners.
outline = [[0, 0], [6, 0], [12, 0], [12, 4], [8, 4], [8, 10], [0, 10]];
n = len(outline);
polyhedron([for (z = [0, 5], p = outline) [p[0], p[1], z]],
           concat([[for (i = [0:n - 1]) i], [for (i = [0:n - 1]) 2 * n - 1 - i]],
                  [for (i = [0:n - 1]) [(i + 1) % n, i, i + n, (i + 1) % n + n]]));
