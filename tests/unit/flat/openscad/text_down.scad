text("Down", direction = "ttb", halign = "center", valign = "top");
