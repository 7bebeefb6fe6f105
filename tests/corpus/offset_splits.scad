// Inward offsets that split a dumbbell into two, and one that leaves nothing.
module dumbbell() {
  square(10);
  translate([10, 4]) square([8, 2]);
  translate([18, 0]) square(10);
}
linear_extrude(3) offset(r = -1.5) dumbbell();
translate([0, 16]) linear_extrude(4) offset(delta = -2) dumbbell();
translate([0, 32]) linear_extrude(5) offset(r = -5.5) dumbbell();
translate([0, 32]) linear_extrude(2) offset(delta = 0) dumbbell();
