// Flat shapes mirrored, sheared, scaled and turned out of their plane: what is left is their shadow on it.
module flag() { square([8, 1.5]); polygon([[0, 0], [5, 4], [0, 7]]); }
linear_extrude(2) flag();
translate([20, 0]) linear_extrude(3) mirror([1, 0, 0]) flag();
translate([0, 12]) linear_extrude(4) rotate([60, 0, 0]) flag();
translate([14, 12]) linear_extrude(5) multmatrix([[1, 0.5, 0, 0], [0, 1, 0, 0], [0, 0, 1, 7]]) flag();
translate([30, 0]) linear_extrude(6) scale([0.5, 2]) flag();
translate([30, 18]) linear_extrude(3) rotate([0, 180, 30]) flag();
translate([45, 0]) linear_extrude(3) scale([0, 1]) flag();
