// Hulls one after another, as people make bent pipes.
points = [[0, 0, 0], [10, 0, 2], [16, 6, 6], [14, 14, 12], [4, 16, 14]];
for (i = [0:3]) hull() {
  translate(points[i]) sphere(2 + 0.3 * i, $fn = 10);
  translate(points[i + 1]) sphere(2.3 + 0.3 * i, $fn = 10);
}
