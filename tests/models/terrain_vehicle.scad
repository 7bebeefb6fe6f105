// terrain_vehicle - an open off-road car, in the place of the second test
// object of F.W. Jansen's thesis (table 4.9 and plate 8): 118 primitives,
// 97 unions, 17 differences and 3 intersections.  The shape is our own.
//
// Forward is +x, left is +y, the ground is z = 0.  Centimetres.
//
// Licence: MIT, the csgsim authors.

round = 64;         // facets of wheels and wheel arches
bar = 16;           // facets of tubes, lamps and caps

axle = 102;         // |x| of the axles
track = 62;         // |y| of the middle of the tyres
tyre = 36;          // radius of the tyres, and height of the axles
half = 68;          // half the width of the tub
bands = 12;         // of which the tub is made
band = 202 / bands;

paint = [0.45, 0.52, 0.28];
shade = [0.36, 0.42, 0.22];
cream = [0.90, 0.85, 0.68];
canvas = [0.70, 0.52, 0.32];
rubber = [0.16, 0.16, 0.17];
steel = [0.42, 0.44, 0.47];
chrome = [0.80, 0.82, 0.85];
black = [0.10, 0.10, 0.11];
white = [0.97, 0.96, 0.88];
amber = [0.95, 0.60, 0.10];
red = [0.80, 0.12, 0.10];

// A bar of the given length along +x, +y.
module bar_x(p, r, length, n = bar)
    translate(p) rotate([0, 90, 0]) cylinder(r = r, h = length, $fn = n);
module bar_y(p, r, length, n = bar)
    translate(p) rotate([-90, 0, 0]) cylinder(r = r, h = length, $fn = n);

// A wheel lying on its back, outside up: the tyre hollowed on the outside, the
// rim in the hollow, the hub on the rim.
module wheel() {
    difference() {
        color(rubber) translate([0, 0, -10])
            cylinder(r = tyre, h = 20, $fn = round);
        color(rubber) translate([0, 0, 4])
            cylinder(r1 = 20, r2 = 25, h = 7, $fn = round);
    }
    color(cream) translate([0, 0, 2]) cylinder(r = 19, h = 5, $fn = 40);
    color(paint) translate([0, 0, 6]) cylinder(r1 = 9, r2 = 6, h = 6, $fn = 24);
}

module wheels() {
    for (x = [-axle, axle]) {
        translate([x, track, tyre]) rotate([-90, 0, 0]) wheel();
        translate([x, -track, tyre]) rotate([90, 0, 0]) wheel();
    }
}

module running_gear() {
    for (x = [-axle, axle]) {
        color(steel) bar_y([x, -56, tyre], 4, 112);
        color(steel) translate([x, 8, tyre]) sphere(r = 11, $fn = 16);
        for (y = [-43, 37])
            color(black) translate([x - 36, y, 29]) cube([72, 6, 4]);
    }
    for (y = [-32, 24])
        color(black) translate([-149, y, 38]) cube([297, 8, 9]);
    for (x = [-146, -8, 134])
        color(black) translate([x, -30, 39.5]) cube([8, 60, 6]);
    color(steel) bar_x([-162, -14, 33], 4, 200);
}

// The tub, riveted from bands, with its cabin, the scoops for getting in, and the wheel arches cut
// through its sides and through the wheel housings within.
module tub() {
    difference() {
        union() {
            difference() {
                for (i = [0 : bands - 1])
                    color(paint) translate([-150 + i * band, -half, 46])
                        cube([i < bands - 1 ? band + 1 : band, 2 * half, 52]);
                color(shade) translate([-145, -half + 4, 54])
                    cube([191, 2 * half - 8, 60]);
                color(paint) translate([-14, -half - 10, 62])
                    cube([44, 2 * half + 20, 60]);
                color(paint) bar_y([-14, -half - 10, 88], 25, 2 * half + 20,
                                   round);
            }
            for (y = [-half + 1, half - 25])
                color(shade) translate([-149, y, 50]) cube([94, 24, 37]);
        }
        arch(-half - 10);
        arch(half - 23);
    }
}

module arch(y) color(shade) bar_y([-axle, y, tyre], 43, 33, round);

module bonnet() {
    color(paint) translate([48, -34, 46.5]) cube([75, 68, 45]);
    intersection() {
        color(paint) translate([50, -36, 89]) cube([82, 72, 20]);
        color(paint) bar_x([40, 0, -17], 120, 100, 96);
    }
    color(black) translate([121, -32, 51]) cube([7, 64, 38]);
}

module grille() {
    difference() {
        color(paint) translate([127, -45, 50]) cube([6, 90, 47]);
        slot(-18);
        slot(-9);
        slot(0);
        slot(9);
        slot(18);
    }
    for (y = [-33.5, 33.5]) {
        color(chrome) bar_x([131, y, 79], 10, 6, 24);
        color(white) translate([136.5, y, 79]) scale([0.4, 1, 1])
            sphere(r = 8.5, $fn = 16);
        color(amber) bar_x([131, y, 60], 4, 5);
    }
}

module slot(y)
    color(black) translate([120, y - 2.5, 57]) cube([20, 5, 33]);

module fender(y) {
    color(paint) translate([58, y, 76]) cube([84, 40, 4]);
    color(paint) translate([138, y + 0.5, 64]) cube([3.5, 39, 14]);
    color(paint) translate([46, y + 0.5, 46]) rotate([0, 25, 0])
        cube([3.5, 39, 34]);
}

// The scuttle, with the windscreen leaning back from it.
module windscreen() {
    color(paint) translate([38, -62, 90]) cube([20, 124, 11]);
    translate([49, 0, 98]) rotate([0, -14, 0]) {
        difference() {
            color(paint) translate([0, -61, 0]) cube([4, 122, 46]);
            color(paint) translate([-5, -56, 6]) cube([14, 112, 35]);
        }
        color(paint) translate([0.5, -2, 4]) cube([3, 4, 40]);
    }
}

module steering() translate([16, 30, 106]) rotate([0, -50, 0]) {
    difference() {
        color(black) cylinder(r = 18, h = 3, $fn = 40);
        color(black) translate([0, 0, -2]) cylinder(r = 15, h = 7, $fn = 40);
    }
    color(steel) translate([-16, -1.2, 0.6]) cube([32, 2.4, 1.8]);
    color(steel) translate([-1.2, -16, 0.7]) cube([2.4, 32, 1.6]);
    color(black) translate([0, 0, -1]) cylinder(r = 4, h = 5, $fn = bar);
    color(steel) translate([0, 0, -32]) cylinder(r = 2, h = 32, $fn = bar);
}

module seat(y) translate([-44, y, 53]) {
    color(canvas) translate([0, -20, 0]) cube([46, 40, 19]);
    translate([2, 0, 10]) rotate([0, -12, 0]) intersection() {
        color(canvas) translate([-8, -20, 0]) cube([9, 40, 56]);
        color(canvas) bar_x([-20, 0, 24], 30, 40, 32);
    }
}

module bench() {
    color(canvas) translate([-132, -42, 53]) cube([40, 84, 18]);
    color(canvas) translate([-139, -42, 53]) cube([9, 84, 48]);
}

module roll_bar() {
    for (y = [-58, 58]) {
        color(steel) translate([-60, y, 53]) cylinder(r = 3.4, h = 97, $fn = bar);
        color(steel) translate([-60, y, 150]) sphere(r = 3.5, $fn = bar);
        color(steel) translate([-60, y, 148]) rotate([0, -123, 0])
            cylinder(r = 3, h = 100, $fn = bar);
    }
    color(steel) bar_y([-60, -58, 150], 3.4, 116);
}

module bumpers() {
    color(steel) translate([146, -66, 37]) cube([7, 132, 13]);
    color(white) translate([152, -17, 39.5]) cube([2, 34, 8]);
    for (y = [-46, 46])
        color(red) translate([149.5, y, 49]) cylinder(r = 3, h = 8, $fn = bar);
    for (y = [-66, 34])
        color(steel) translate([-157, y, 38]) cube([9, 32, 10]);
}

module rear() {
    translate([-162, -20, 86]) rotate([0, -90, 0]) wheel();
    color(steel) bar_x([-158, -20, 86], 8, 10);
    color(shade) translate([-171, 26, 56]) cube([22.5, 32, 41.5]);
    color(black) translate([-160, 48, 97]) cylinder(r = 4, h = 5, $fn = bar);
    for (y = [-61, 63])
        color(red) bar_x([-154, y, 88], 4, 6);
}

module trim_parts() {
    // Mirror, fuel cap, steps and grab handles.
    color(steel) bar_y([47, 58, 112], 1.3, 20, 8);
    color(chrome) bar_x([45, 80, 112], 7, 3, 24);
    color(chrome) bar_y([-44, half - 2, 84], 5, 4, 24);
    for (y = [-80, 60])
        color(black) translate([-26, y, 43]) cube([62, 20, 5]);
    for (y = [-70, 66])
        color(steel) translate([-136, y, 91]) cube([40, 4, 3]);
}

wheels();
running_gear();
tub();
bonnet();
grille();
fender(34);
fender(-74);
windscreen();
steering();
seat(30);
seat(-30);
bench();
roll_bar();
bumpers();
rear();
trim_parts();
