// What shares a wall with what is subtracted: pockets to the edge, a lid taken off flush.
difference() {
  linear_extrude(8) polygon([[0, 0], [20, 0], [20, 12], [12, 12], [12, 6], [6, 6], [6, 12], [0, 12]]);
  translate([0, 0, 5]) linear_extrude(3) square([6, 12]);
  translate([12, 8, 0]) cube([8, 4, 8]);
  translate([20, 0, 4]) rotate([0, -90, 0]) linear_extrude(6) polygon([[0, 0], [4, 0], [4, 6]]);
}
