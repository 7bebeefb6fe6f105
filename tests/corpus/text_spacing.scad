// Letters closer and farther apart.
spacings = [0.7, 1, 1.6];
for (i = [0:2]) translate([0, i * 11]) linear_extrude(2 + i)
  text("AVoid", size = 8, font = "DejaVu Sans", spacing = spacings[i]);
