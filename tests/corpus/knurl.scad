// A knob: a body turned from a profile, less grooves twisted both ways.
difference() {
  rotate_extrude($fn = 30) polygon([[0, 0], [9, 0], [10, 1], [10, 11], [9, 12], [0, 12]]);
  for (s = [-1, 1], i = [0:9]) rotate(36 * i) translate([0, 0, -1])
    linear_extrude(14, twist = s * 60, slices = 6) translate([10.3, 0]) rotate(45) square(1.2, center = true);
  translate([0, 0, -1]) cylinder(9, 3, 3, $fn = 6);
}
