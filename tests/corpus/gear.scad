// A gear less its shaft with a key, and less holes.
teeth = 14;
difference() {
  linear_extrude(5) difference() {
    union() {
      circle(14, $fn = 42);
      for (i = [0:teeth - 1]) rotate(360 * i / teeth) translate([13, 0])
        polygon([[0, -2.2], [4, -1], [4, 1], [0, 2.2]]);
    }
    circle(3, $fn = 20);
    translate([2, -1]) square([3, 2]);
  }
  for (i = [0:4]) rotate(72 * i) translate([8.5, 0, -1]) cylinder(9, 2, 2, $fn = 16);
  translate([0, 0, 3]) rotate_extrude($fn = 32) translate([5, 0]) square([7, 9]);
}
