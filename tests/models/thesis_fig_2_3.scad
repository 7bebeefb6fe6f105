// thesis_fig_2_3 - the introductory object of F.W. Jansen, "Solid modelling
// with faceted primitives" (1987), fig. 2.3:
//
//   A = block 20 12 6
//   B = block 16 8 8       move B 2 -1
//   C = cylinder 8 10      move C z -2
//   Object = A - [B n C]
//
// The printed commands are only partly legible.  Here B is also raised so that
// the pocket keeps a floor, and C is moved to the middle of the front face:
// a round pocket with a flat back, open above and in front.
//
// 3 primitives: 1 difference, 1 intersection.
// Licence: MIT, the csgsim authors.

facets = 48;

module A() color([0.80, 0.25, 0.20]) cube([20, 12, 6]);

module B() color([0.95, 0.75, 0.25])
    translate([2, -1, 2]) cube([16, 8, 8]);

// Turned half a facet, so that no edge of C lies in a face of B.
module C() color([0.25, 0.45, 0.80])
    translate([10, 0, -2]) rotate([0, 0, 180 / facets])
        cylinder(r = 8, h = 10, $fn = facets);

difference() {
    A();
    intersection() {
        B();
        C();
    }
}
