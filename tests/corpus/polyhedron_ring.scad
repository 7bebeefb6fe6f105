// A polyhedron with a hole through it, of quadrilaterals.
n = 12;
m = 5;
points = [for (i = [0:n - 1], j = [0:m - 1]) let (a = 360 * i / n, b = 360 * j / m, r = 8 + 3 * cos(b)) [r * cos(a), r * sin(a), 3 * sin(b)]];
faces = [for (i = [0:n - 1], j = [0:m - 1]) [i * m + j, i * m + (j + 1) % m, (i + 1) % n * m + (j + 1) % m, (i + 1) % n * m + j]];
polyhedron(points, faces);
