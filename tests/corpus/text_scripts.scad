// Other scripts: Greek, Cyrillic, and Arabic, whose letters join and run to the left.
linear_extrude(2) text("Ωμέγα", size = 9, font = "DejaVu Sans", script = "Grek", language = "el");
translate([0, 14]) linear_extrude(3) text("Щука", size = 9, font = "DejaVu Sans", script = "Cyrl", language = "ru");
translate([0, 30]) linear_extrude(4) text("سلام", size = 12, font = "DejaVu Sans", script = "Arab", language = "ar", direction = "rtl");
