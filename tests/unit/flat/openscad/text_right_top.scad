text("AVATar office", font = "DejaVu Sans", halign = "right", valign = "top", spacing = 1.3);
