// An STL file as other programs leave it: corners that differ in digits that a 32-bit float does not hold, a triangle without an
// area, one that comes again and back.
difference() {
  import("data/rough.stl");
  translate([2, 1, 3]) cube([9, 2, 9]);
}
