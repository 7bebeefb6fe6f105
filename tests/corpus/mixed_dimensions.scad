// Flat shapes and solids as operands of one node, and empty ones: the first operand that is not nothing says which of them count. Each case as
// it is, and extruded, which tells flat from solid.
module cases() {
  translate([0, -4, 0]) cube([70, 2, 1]);
  case(0) intersection() { cube(6); square(4); }
  case(1) intersection() { square(4); cube(6); }
  case(2) difference() { cube(6); translate([1, 1]) square(4); }
  case(3) difference() { square(6); translate([1, 1, -1]) cube(4); }
  case(4) union() { square(0); cube(4); }
  case(5) union() { union() { square(0); } cube(4); }
  case(6) union() { union() { square(0); square(0); } cube(4); }
  case(7) union() { cube(0); square(4); }
  case(8) union() { group() { } square(4); }
  case(9) difference() { circle(r = 0); cube(4); }
  case(10) hull() { square(4); translate([5, 5, 5]) cube(1); }
  case(11) hull() { cube(4); translate([5, 5]) square(1); }
  case(12) minkowski() { square(3); cube(3); }
  case(13) minkowski() { cube(3); square(3); }
  case(14) minkowski() { circle(r = 0); square(4); }
  case(15) minkowski() { square(4); circle(r = 0); }
  case(16) union() { intersection() { cube(4); square(4); } square(5); }
  case(17) union() { intersection() { square(4); cube(4); } cube(5); }
  case(18) union() { difference() { cube(2); translate([-1, -1, -1]) cube(5); } square(4); }
  case(19) union() { linear_extrude(3) square(0); square(4); }
  case(20) union() { linear_extrude(3) { square(0); square(0); } square(4); }
  case(21) union() { projection() square(3); cube(4); }
  case(22) union() { resize([4, 4, 4]) square(0); cube(3); }
  case(23) union() { hull() { cube(0); } square(4); }
  case(24) union() { cube(3); square(0); }
  case(25) union() { offset(1) square(0); cube(3); }
  case(26) union() { rotate_extrude(angle = 0) square(3); square(4); }
  case(27) union() { intersection() { cube(0); cube(3); } square(4); }
  case(28) union() { intersection() { cube(3); cube(0); } square(4); }
  case(29) union() { union() { cube(0); cube(0); } square(4); }
  case(30) union() { text(""); cube(3); }
  case(31) union() { hull() { square(0); } cube(4); }
}
module case(n) {
  translate([9 * (n % 8), 18 * floor(n / 8) + 9, 0]) linear_extrude(3) children();
  translate([9 * (n % 8), 18 * floor(n / 8), 0]) children();
}
cases();
