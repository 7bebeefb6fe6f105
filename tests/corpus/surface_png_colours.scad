// Heights from a picture's colours, by how bright they are.
scale([2, 2, 0.1]) surface("data/colours.png", center = true);
