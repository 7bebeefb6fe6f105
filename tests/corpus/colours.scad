// Colours by name, by numbers and by digits, on extrusions, hulls and what is inside; the outermost counts.
color("steelblue") linear_extrude(3) circle(5);
color([1, 0.2, 0]) translate([12, 0, 0]) hull() { cube(3); translate([4, 4, 4]) sphere(2, $fn = 10); }
color("green") translate([24, 0, 0]) union() { color("red") rotate_extrude($fn = 12) translate([3, 0]) circle(1.5, $fn = 8); cube(2, center = true); }
difference() { color("#ffa500") translate([0, 12, 0]) cube(8); color("purple") translate([4, 16, 4]) linear_extrude(9) text("x", font = "DejaVu Sans"); }
