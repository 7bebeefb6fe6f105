// A shape beside the origin leans when it is scaled; its hole leans with it.
linear_extrude(height = 12, scale = 0.4) translate([10, 4]) difference() {
  circle(6, $fn = 20);
  circle(4, $fn = 5);
}
translate([-6, 0, 0]) linear_extrude(height = 12, scale = [1, 2.5], slices = 4) translate([-6, 1]) square([4, 3]);
