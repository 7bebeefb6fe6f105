// Accents, ligatures, a sign of two parts.
linear_extrude(3) text("Ångström", size = 10, font = "DejaVu Serif");
translate([0, 16]) linear_extrude(3) text("çœñß ¿ö¡", size = 10, font = "DejaVu Sans:style=Bold");
