// An OFF file with faces of six corners that are not convex, and with colours, which are left out.
import("data/angle.off");
difference() {
  translate([20, 0, 0]) import("data/angle.off");
  translate([22, 2, -1]) cylinder(9, 1, 1, $fn = 12);
}
