// carburettor - a slide carburettor, after the first test object of F.W.
// Jansen's thesis (table 4.9 and plate 7): 22 primitives, 11 unions and
// 10 differences, about 2000 linear half-spaces.  The shape is our own.
//
// The bore runs along x: intake bell at +x, engine flange at -x.  The slide
// tower stands on the barrel, the float bowl hangs below it.  Millimetres.
//
// Licence: MIT, the csgsim authors.

big = 96;       // facets of the large round parts
small = 64;     // facets of pipes, screws and holes
dome = 32;      // facets round the dome of the float bowl

bore = 12;      // radius of the bore
barrel = 18;    // radius of the barrel
front = 46;     // x of the mouth of the intake bell
back = -42;     // x of the engine side of the flange
bowl_x = 4;     // x of the axis of the float bowl

aluminium = [0.74, 0.76, 0.79];
machined = [0.90, 0.91, 0.93];
cast = [0.55, 0.58, 0.63];
brass = [0.85, 0.65, 0.22];
black = [0.20, 0.21, 0.24];
dark = [0.38, 0.34, 0.30];

module along_x(x) translate([x, 0, 0]) rotate([0, 90, 0]) children();
module along_y(x, y, z) translate([x, y, z]) rotate([90, 0, 0]) children();

// Barrel, bell and elliptical engine flange; bored through, the bell flared,
// two bolt slots in the flange.
module body() {
    difference() {
        union() {
            color(aluminium) along_x(back + 2)
                cylinder(r = barrel, h = front - back - 6, $fn = big);
            color(aluminium) along_x(front - 22)
                cylinder(r1 = barrel - 1, r2 = 29, h = 22, $fn = big);
            color(cast) along_x(back) scale([0.62, 1, 1])
                cylinder(r = 42, h = 8, $fn = big);
        }
        color(machined) along_x(back - 5)
            cylinder(r = bore, h = front - back + 10, $fn = big);
        color(machined) along_x(front - 17.5)
            cylinder(r1 = bore - 1.5, r2 = 26, h = 18, $fn = big);
        bolt_slot(31);
        bolt_slot(-31);
    }
}

module bolt_slot(y)
    color(dark) along_x(back - 1) translate([0, y, 0]) scale([1, 1.5, 1])
        cylinder(r = 3.6, h = 10, $fn = small);

// Slide tower with its tapered cap and the guide of the throttle cable.
module tower() {
    difference() {
        union() {
            color(aluminium) translate([0, 0, bore + 1])
                cylinder(r = 16, h = 40, $fn = big);
            color(black) translate([0, 0, 46])
                cylinder(r1 = 21, r2 = 17, h = 13, $fn = big);
            color(brass) translate([0, 0, 56])
                cylinder(r = 5.5, h = 18, $fn = small);
        }
        color(dark) translate([0, 0, 60])
            cylinder(r = 3.2, h = 20, $fn = small);
    }
}

// Float bowl: lip with two screw holes, bowl, domed bottom and drain plug.
module bowl() translate([bowl_x, 0, 0]) {
    difference() {
        color(cast) translate([0, 0, -27])
            cylinder(r = 33, h = 8, $fn = big);
        lip_hole(21);
        lip_hole(-21);
    }
    color(aluminium) translate([0, 0, -46])
        cylinder(r = 26, h = 34, $fn = big);
    color(aluminium) translate([0, 0, -46]) scale([1, 1, 0.5])
        sphere(r = 25.5, $fn = dome);
    color(brass) translate([0, 0, -65])
        cylinder(r = 8, h = 9, $fn = 6);
}

module lip_hole(x)
    color(dark) translate([x, -21, -30])
        cylinder(r = 2.8, h = 15, $fn = small);

// Fuel pipe into the side of the float bowl.
module fuel_pipe() {
    difference() {
        color(brass) along_y(bowl_x, -22, -36)
            cylinder(r = 5.5, h = 28, $fn = small);
        color(dark) along_y(bowl_x, -30, -36)
            cylinder(r = 3.2, h = 25, $fn = small);
    }
}

// Idling screw in the side of the barrel, with the slot for a screwdriver.
module idle_screw() {
    difference() {
        color(brass) along_y(-18, -12, 2)
            cylinder(r = 6, h = 15, $fn = small);
        color(dark) translate([-25, -30, 1])
            cube([14, 6, 2]);
    }
}

difference() {
    union() {
        body();
        tower();
        bowl();
        fuel_pipe();
        idle_screw();
    }
    // Vent of the float bowl, from below the lip up into the mouth of the bell.
    color(dark) translate([bowl_x + 29.5, 0, -35])
        cylinder(r = 2.4, h = 30, $fn = small);
}
