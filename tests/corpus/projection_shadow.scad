// The shadow of solids on the plane: turned, with a hole straight through, in several parts.
linear_extrude(3) projection() rotate([35, 25, 10]) cube(8, center = true);
translate([16, 0]) linear_extrude(4) projection() difference() { cylinder(6, 7, 3); translate([0, 0, -1]) cylinder(9, 2, 2); }
translate([32, 0]) linear_extrude(5) projection() { sphere(4); translate([8, 0, 20]) cube(4); translate([3, 0, 5]) cube([9, 1, 1]); }
