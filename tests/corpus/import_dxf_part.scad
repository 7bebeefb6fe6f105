// A drawing cut by hand: a plate less its slot and its holes.
linear_extrude(5) difference() {
  import("data/shapes.dxf", layer = "plate");
  import("data/shapes.dxf", layer = "slot", $fn = 24);
  import("data/shapes.dxf", layer = "holes", $fn = 24);
}
