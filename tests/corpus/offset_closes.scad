// An outward offset closes a hole and a slit; out and in again it rounds; in and out again it opens.
module plate() difference() {
  square([30, 16]);
  translate([6, 8]) circle(2);
  translate([14, 8]) circle(4);
  translate([21, 4]) square([1.5, 20]);
}
linear_extrude(3) offset(r = 2.2, $fn = 16) plate();
translate([0, 24]) linear_extrude(4) offset(r = -2, $fn = 16) offset(delta = 2) plate();
translate([0, 46]) linear_extrude(5) offset(r = 1.5, $fn = 16) offset(r = -1.5, $fn = 16) plate();
