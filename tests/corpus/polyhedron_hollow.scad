// A polyhedron of two shells: a cube with a hollow, and a hole cut to look in.
function corners(a, b) = [for (z = [a, b], y = [a, b], x = [a, b]) [x, y, z]];
sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
difference() {
  polyhedron(concat(corners(0, 10), corners(2, 8)),
             concat(sides, [for (f = sides) [8 + f[3], 8 + f[2], 8 + f[1], 8 + f[0]]]));
  translate([4, -3, 4]) cube([4, 6, 8]);
}
