// ! draws one node alone: the extrusion, not what is around it.
cube(50);
translate([100, 0, 0]) {
  sphere(9);
  !linear_extrude(4, twist = 60, slices = 5) square([10, 5], center = true);
}
