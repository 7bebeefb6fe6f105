// Differences and intersections of them, in one another.
difference() {
  union() { cube([16, 10, 4]); translate([8, 5, 3]) cylinder(5, 4, 3, $fn = 20); }
  translate([8, 5, -1]) cylinder(20, 1.5, 1.5, $fn = 12);
  translate([3, -1, 2]) cube([2, 20, 9]);
  intersection() { translate([16, 10, 4]) sphere(4, $fn = 14); translate([11, 5, 1]) cube(9); }
}
translate([24, 5, 2]) intersection() { sphere(5, $fn = 18); cube([8, 6, 9], center = true); }
