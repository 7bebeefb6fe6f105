// A connecting rod of 24 primitives.
$fn = 48;
difference() {
  union() {
    cylinder(h = 30, r = 34, center = true);                                   // big end
    translate([130, 0, 0]) cylinder(h = 34, r = 20, center = true);            // small end
    translate([72, 0, 0]) rotate([0, 90, 0]) cylinder(h = 92, r1 = 15, r2 = 11, center = true);  // shank
    translate([30, 0, 0]) sphere(r = 17);                                      // its roots
    translate([112, 0, 0]) sphere(r = 13);
    for (y = [-1, 1]) translate([0, y * 33, 0]) rotate([0, 90, 0]) cylinder(h = 40, r = 10, center = true);  // bosses
    for (y = [-1, 1]) translate([-21, y * 33, 0]) rotate([0, 90, 0]) cylinder(h = 10, r = 8, center = true);  // bolt heads
    for (y = [-1, 1]) translate([22, y * 33, 0]) sphere(r = 7);                // nuts
    translate([112, 0, 15]) cylinder(h = 10, r1 = 9, r2 = 5, center = true);   // oil cup
    translate([112, 0, 20]) sphere(r = 5);
  }
  cylinder(h = 32, r = 26, center = true);                                     // crank pin
  translate([130, 0, 0]) cylinder(h = 40, r = 13, center = true);              // wrist pin
  translate([72, 0, 14]) scale([3.2, 0.5, 0.5]) sphere(r = 13);                // lightened shank
  translate([72, 0, -14]) scale([3.2, 0.5, 0.5]) sphere(r = 13);
  translate([0, 0, 15]) cylinder(h = 4, r1 = 26, r2 = 30, center = true);      // chamfers
  translate([0, 0, -15]) cylinder(h = 4, r1 = 30, r2 = 26, center = true);
  for (y = [-1, 1]) translate([0, y * 33, 0]) rotate([0, 90, 0]) cylinder(h = 60, r = 3, center = true);  // bolt holes
  translate([112, 0, 15]) cylinder(h = 24, r = 1.5, center = true);            // oil hole
  translate([0, 0, -1]) rotate([90, 0, 0]) cylinder(h = 90, r = 1.5, center = true);  // joint's oil way
  cube([0.6, 100, 40], center = true);                                         // joint of the cap
}
