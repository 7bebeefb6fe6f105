// notched_step - a slab and a wall with a notch through the wall into the slab:
// the model of docs/lessons.md, small enough for paper.
//
// 3 primitives: 1 union, 1 difference.
// Licence: MIT, the csgsim authors.

module A() color([0.35, 0.60, 0.90]) cube([12, 12, 4]);

module B() color([0.95, 0.75, 0.25]) cube([4, 12, 10]);

module N() color([0.90, 0.40, 0.35]) translate([2, 4, 2]) cube([12, 4, 10]);

difference() {
    union() {
        A();
        B();
    }
    N();
}
