text("Quickly", size = 7, font = "Liberation Serif:style=Italic", halign = "center", valign = "center", $fn = 16);
