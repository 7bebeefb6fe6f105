// render() keeps what is in it together, alone and within a difference.
difference() {
  render(convexity = 3) union() { cube([12, 8, 4]); translate([6, 4, 2]) cylinder(6, 3, 3, $fn = 16); }
  render() translate([6, 4, -1]) cylinder(12, 2, 1, $fn = 16);
}
