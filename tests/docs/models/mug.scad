$fn = 48;
module handle() translate([40, 6, 40]) rotate([90, 0, 0]) difference() { cylinder(h = 12, r = 28); cylinder(h = 12, r = 20); }
difference() { union() { cylinder(h = 80, r = 35); handle(); } translate([0, 0, 5]) cylinder(h = 80, r = 31); }
