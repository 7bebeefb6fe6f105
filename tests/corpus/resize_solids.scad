// Solids resized: every side, one side, one side and the others by proportion, one side and one other.
module thing() difference() { cube([4, 6, 3]); translate([1, 1, -1]) cube([2, 2, 9]); }
resize([8, 8, 8]) thing();
translate([12, 0, 0]) resize([8, 0, 0]) thing();
translate([24, 0, 0]) resize([8, 0, 0], auto = true) thing();
translate([36, 0, 0]) resize([0, 9, 0], auto = [false, true, true]) thing();
translate([0, 16, 0]) resize([6, 4, 9]) sphere(5, $fn = 12);
