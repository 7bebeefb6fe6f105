difference() {
    rotate([0, 0, 30]) cube([12, 12, 4]);
    rotate([0, 0, 30]) translate([2, 2, 2]) cube([4, 8, 10]);
    rotate([0, 0, 10]) rotate([0, 0, 20]) translate([6, 2, 2]) cube([4, 8, 10]);
}
