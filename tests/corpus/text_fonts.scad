// Other fonts and styles.
linear_extrude(2) text("Roman", size = 8, font = "Liberation Serif");
translate([0, 11]) linear_extrude(3) text("Slanted", size = 8, font = "Liberation Sans:style=Bold Italic");
translate([0, 22]) linear_extrude(4) text("mono 1l", size = 8, font = "DejaVu Sans Mono");
