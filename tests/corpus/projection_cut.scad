// The section at z = 0: through a hole, through two parts; of what lies above there is none.
module thing() difference() {
  union() { sphere(8); translate([10, 0, -3]) rotate([0, 20, 0]) cylinder(12, 4, 2); }
  rotate([90, 0, 0]) cylinder(30, 2, 2, center = true);
  translate([-3, -3, -10]) cube([2, 6, 20]);
}
linear_extrude(3) projection(cut = true) thing();
translate([0, 20]) linear_extrude(3) projection(cut = true) translate([0, 0, 4]) thing();
linear_extrude(30) projection(cut = true) translate([0, 0, 40]) thing();
