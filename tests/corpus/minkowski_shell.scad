// A case: a rounded box less the same box smaller.
difference() {
  minkowski() { cube([16, 12, 5]); cylinder(1, 2, 2, $fn = 16); }
  translate([0, 0, 1]) minkowski() { cube([16, 12, 5]); cylinder(1, 1, 1, $fn = 16); }
  translate([8, 6, -1]) cylinder(4, 3, 3, $fn = 20);
}
