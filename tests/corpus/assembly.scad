// Groups, transforms and Booleans around everything: a lamp.
color("dimgray") rotate_extrude($fn = 28) polygon([[0, 0], [10, 0], [10, 1.5], [2, 3], [0, 3]]);
color("silver") for (i = [0:3]) hull() {
  translate([3 * sin(30 * i), 0, 3 + 6 * i]) sphere(1, $fn = 8);
  translate([3 * sin(30 * (i + 1)), 0, 9 + 6 * i]) sphere(1, $fn = 8);
}
color("gold") translate([3 * sin(120), 0, 27]) rotate([0, 30, 0]) difference() {
  linear_extrude(9, scale = 0.5, center = true) circle(7, $fn = 18);
  translate([0, 0, -0.5]) linear_extrude(9, scale = 0.5, center = true) circle(6.5, $fn = 18);
}
