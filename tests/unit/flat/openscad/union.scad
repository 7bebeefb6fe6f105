square([3, 2]);
translate([2.3, 1.1]) circle(r = 1.5, $fn = 32);
translate([-4, 0]) square(1);
