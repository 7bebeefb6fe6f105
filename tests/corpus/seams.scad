// Solids that share walls: stacked extrusions, a ring in a plate's hole, hulls end to end; no seam may show.
linear_extrude(3) circle(8, $fn = 30);
translate([0, 0, 3]) linear_extrude(3) circle(8, $fn = 30);
translate([20, 0, 0]) { linear_extrude(5) difference() { square(16, center = true); circle(5, $fn = 24); } linear_extrude(5) difference() { circle(5, $fn = 24); circle(2); } }
translate([0, 14, 0]) { hull() { cube(4); translate([6, 0, 0]) cube([2, 4, 6]); } translate([8, 0, 0]) hull() { cube([2, 4, 6]); translate([8, 0, 0]) cube(4); } }
