// Ground in a round box, with a post on it.
intersection() {
  translate([0, 0, 1.5]) surface("data/hills.dat", center = true);
  cylinder(20, 5, 5, $fn = 24);
}
translate([2, 1, 0]) cylinder(12, 0.4, 0.4, $fn = 8);
