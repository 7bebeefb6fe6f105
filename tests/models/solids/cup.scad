// A handle that is a ring goes through the wall of a hollow.
difference() {
  union() {
    cylinder(r = 10, h = 20, $fn = 20);
    translate([10, 0, 10]) rotate([90, 0, 0]) rotate_extrude($fn = 16) translate([6, 0]) circle(r = 1.5, $fn = 8);
  }
  translate([0, 0, 2]) cylinder(r = 8.5, h = 20, $fn = 20);
}
