// What was flat comes back: extruded, turned, cut and extruded again.
linear_extrude(4) projection(cut = true) rotate([90, 0, 0]) translate([0, 0, -1])
  linear_extrude(2) difference() { circle(8); translate([1, 1]) square(5); }
translate([22, 0]) linear_extrude(4) projection(cut = true) rotate([70, 0, 0]) translate([0, 0, -6])
  linear_extrude(12, twist = 90, slices = 6) square(10, center = true);
