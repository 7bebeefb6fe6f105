// Text downwards, upwards and from right to left.
linear_extrude(2) text("down", size = 7, font = "DejaVu Sans", direction = "ttb");
translate([20, 0]) linear_extrude(3) text("up", size = 7, font = "DejaVu Sans", direction = "btt");
translate([60, -10]) linear_extrude(4) text("left", size = 7, font = "DejaVu Sans", direction = "rtl");
translate([40, -20]) linear_extrude(5) text("mid", size = 7, font = "DejaVu Sans", direction = "ttb", halign = "center", valign = "center");
