// % and * leave out, # draws, on the new nodes too.
linear_extrude(3) { square(8); %translate([10, 0]) circle(3); }
%translate([0, 0, 20]) hull() { cube(1); translate([9, 9, 9]) cube(1); }
*rotate_extrude() translate([30, 0]) circle(9);
#translate([14, 0, 0]) minkowski() { cube(3); sphere(1, $fn = 8); }
translate([0, 14, 0]) hull() { cube(2); #translate([6, 0, 0]) cube(3); %translate([0, 0, 30]) cube(2); }
translate([14, 14, 0]) difference() { cube(6); #translate([3, 3, 2]) cylinder(9, 2, 2, $fn = 12); }
