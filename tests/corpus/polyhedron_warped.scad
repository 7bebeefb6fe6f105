// Faces whose four corners are not in one plane: OpenSCAD cuts them into triangles, this way or that.
polyhedron([[0, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0], [0, 0, 5], [8, 0, 7], [8, 8, 5], [0, 8, 7]],
           [[0, 1, 2, 3], [7, 6, 5, 4], [4, 5, 1, 0], [5, 6, 2, 1], [6, 7, 3, 2], [7, 4, 0, 3]]);
