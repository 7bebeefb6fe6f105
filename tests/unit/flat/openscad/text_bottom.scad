text("gjpqy_", size = 4, font = " DejaVu Sans Mono:style=Bold ", valign = "bottom", spacing = 0.7);
