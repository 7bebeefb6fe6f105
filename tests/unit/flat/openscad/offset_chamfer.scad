offset(delta = 1.25, chamfer = true) polygon([[0, 0], [10, 0], [3, 3], [0, 10]]);
