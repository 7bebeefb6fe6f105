// A polyhedron that is not convex: an eight-pointed star of quadrilaterals and triangles.
n = 8;
points = concat([for (i = [0:2 * n - 1]) (i % 2 == 0 ? 10 : 5) * [cos(180 * i / n), sin(180 * i / n), 0]], [[0, 0, 5], [0, 0, -3]]);
faces = [for (i = [0:2 * n - 1], s = [0, 1]) s == 0 ? [(i + 1) % (2 * n), i, 2 * n] : [i, (i + 1) % (2 * n), 2 * n + 1]];
polyhedron(points, faces);
