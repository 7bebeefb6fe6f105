multmatrix([[2, 0.5, 3, 4], [0.25, 1.5, 5, -6], [7, 8, 9, 10], [0, 0, 0, 1]])
  difference() {
    square(5);
    translate([1, 1]) square(2);
  }
