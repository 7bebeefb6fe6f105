// One polyhedron of two solids apart, and one whose parts are extruded stairs.
function corners(o, s) = [for (z = [0, s], y = [0, s], x = [0, s]) o + [x, y, z]];
sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
polyhedron(concat(corners([0, 0, 0], 5), corners([8, 2, 1], 4)), concat(sides, [for (f = sides) [for (i = f) i + 8]]));
