// A wall bracket: two plates with rounded corners, a web with a window, countersunk holes, and its load engraved.
width = 40;
depth = 50;
height = 60;
thick = 5;

module plate(length) {
  linear_extrude(thick) difference() {
    hull() { translate([0, -width / 2]) square([1, width]); for (s = [-1, 1]) translate([length - 8, s * (width / 2 - 8)]) circle(8, $fn = 40); }
  }
}

module countersunk() {
  translate([0, 0, -1]) cylinder(h = 20, r = 2.6, $fn = 28);
  translate([0, 0, thick - 2.8]) cylinder(h = 2.81, r1 = 2.6, r2 = 5.4, $fn = 36);
}

color("slategray") difference() {
  union() {
    plate(depth);
    translate([0, 0, 0]) mirror([1, 0, -1]) plate(height);
    // the web, in the middle
    rotate([90, 0, 0]) linear_extrude(5, center = true) difference() {
      polygon([[thick - 1, thick - 1], [depth - 8, thick - 1], [thick - 1, height - 8]]);
      translate([thick + 2, thick + 2]) offset(r = 2, $fn = 24) offset(delta = -2) polygon([[2, 2], [depth - 26, 2], [2, height - 28]]);
    }
    // the inner corner, filled round
    translate([thick, 0, thick]) rotate([90, 0, 0]) linear_extrude(width, center = true) difference() { square(4); translate([4, 4]) circle(4, $fn = 32); }
  }
  for (s = [-1, 1]) {
    translate([depth - 12, s * 11, 0]) countersunk();
    translate([0, s * 11, height - 12]) rotate([0, 90, 0]) countersunk();
    translate([0, s * 11, 18]) rotate([0, 90, 0]) countersunk();
  }
  translate([22, -13, thick - 0.6]) linear_extrude(2) text("25 kg", size = 6, font = "DejaVu Sans:style=Bold", halign = "center", valign = "center");
}
