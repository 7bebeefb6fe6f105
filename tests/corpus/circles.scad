// Circles: fragments by $fn, by $fa and $fs, the least number of them; a circle of no radius is nothing.
linear_extrude(2) circle(5);
translate([12, 0]) linear_extrude(3) circle(d = 10, $fn = 3);
translate([24, 0]) linear_extrude(4) circle(r = 5, $fn = 5);
translate([0, 12]) linear_extrude(5) circle(r = 5, $fn = 1);
translate([12, 12]) linear_extrude(6) circle(r = 5, $fa = 5, $fs = 0.5);
translate([24, 12]) linear_extrude(7) circle(r = 5, $fn = 90);
translate([18, 6]) linear_extrude(8) circle(r = 0.5);
linear_extrude(50) circle(0);
