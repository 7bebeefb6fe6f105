// Squares: a number, a vector, centred, thinner than its neighbours; a square of no size is nothing.
linear_extrude(2) square(6);
translate([8, 0, 0]) linear_extrude(3) square([4, 9]);
translate([18, 4, 0]) linear_extrude(4) square([7.5, 3], center = true);
translate([24, 0, 0]) linear_extrude(5) square([0.4, 9]);
linear_extrude(50) square(0);
linear_extrude(50) square([5, 0]);
