// Squares that touch along an edge, along part of one, and at a corner; a difference that leaves two that touch there.
// (One extrusion alone: OpenSCAD cannot take corners that touch into a union of solids.)
linear_extrude(3) {
  square(4);
  translate([4, 0]) square(4);
  translate([8, 2]) square(4);
  translate([12, 6]) square(4);
  translate([0, 12]) difference() {
    square(10);
    square(5);
    translate([5, 5]) square(5);
  }
}
