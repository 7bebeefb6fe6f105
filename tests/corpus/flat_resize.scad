// Flat shapes resized: both sides, one side, one side and the other by proportion.
module drop() { circle(3); polygon([[-3, 0], [3, 0], [0, 8]]); }
linear_extrude(2) resize([10, 6]) drop();
translate([14, 0]) linear_extrude(3) resize([10, 0]) drop();
translate([32, 0]) linear_extrude(4) resize([10, 0], auto = true) drop();
translate([48, 0]) linear_extrude(5) resize([0, 16], auto = [true, false]) drop();
