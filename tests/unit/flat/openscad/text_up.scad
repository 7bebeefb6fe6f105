text("Upwards", direction = "btt", halign = "right", valign = "center", spacing = 1.2);
