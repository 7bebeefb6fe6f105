text("Arial?", font = "Arial:style=Bold Italic");
