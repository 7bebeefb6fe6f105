// Every alignment, about a mark each.
across = ["left", "center", "right"];
up = ["top", "center", "baseline", "bottom"];
for (i = [0:2], j = [0:3]) translate([i * 32, j * 16]) {
  linear_extrude(4) square(0.8, center = true);
  linear_extrude(2) text("Ajg", size = 7, font = "DejaVu Sans", halign = across[i], valign = up[j]);
}
