// rietveld_house - the Rietveld-Schroder house in Utrecht (Gerrit Rietveld,
// 1924), after the third test object of F.W. Jansen's thesis (table 4.9 and
// plate 9): 91 primitives, 87 unions, 3 differences, no intersection.  A free
// impression of planes and lines, not a survey.
//
// The street front is y = 0, the garden front x = 1000, the street is z = 0.
// Centimetres.
//
// Licence: MIT, the csgsim authors.

white = [0.96, 0.95, 0.92];
light = [0.80, 0.81, 0.81];
grey = [0.58, 0.60, 0.62];
slate = [0.36, 0.38, 0.41];
black = [0.11, 0.11, 0.12];
glass = [0.30, 0.40, 0.48];
red = [0.82, 0.12, 0.10];
yellow = [0.96, 0.80, 0.10];
blue = [0.10, 0.25, 0.65];
brick = [0.55, 0.30, 0.22];
grass = [0.45, 0.58, 0.30];
paving = [0.70, 0.66, 0.60];

// A block from corner a to corner b.
module block(c, a, b) color(c) translate(a) cube(b - a);

// A rail of radius 3 and the given length, upright or along x or y.
module upright(c, p, length) color(c) translate(p)
    cylinder(r = 3, h = length, $fn = 12);
module rail_x(c, p, length) translate(p) rotate([0, 90, 0])
    upright(c, [0, 0, 0], length);
module rail_y(c, p, length) translate(p) rotate([-90, 0, 0])
    upright(c, [0, 0, 0], length);

module grounds() {
    block(grass, [-140, -340, -20], [1300, 800, 0]);
    block(paving, [440, -341, -10], [640, 20, 4]);
    block(paving, [990, 470, -10], [1301, 660, 4]);
    block(light, [460, -60, 2], [620, 124, 14]);
    block(light, [995, 500, 1], [1090, 640, 14]);
    block(brick, [-75, 12, -5], [-5, 720, 700]);
}

// The body of the house, less the porch, the corner window, which has no post
// in the corner, and the loggia of the garden balcony.
module body() {
    difference() {
        block(light, [-10, 0, -6], [1000, 700, 585]);
        block(slate, [470, -10, 10], [610, 110, 245]);
        block(light, [710, -10, 350], [1010, 250, 560]);
        block(grey, [920, 450, 300], [1010, 680, 560]);
    }
}

module roof() {
    block(white, [-14, -16, 580], [986, 706, 606]);
    block(white, [630, -100, 572], [1100, 320, 592]);
    block(white, [420, 280, 600], [640, 470, 655]);
    block(glass, [432, 292, 640], [628, 458, 668]);
    block(grey, [150, 480, 600], [235, 565, 735]);
    upright(black, [172, 522, 730], 45);
    upright(black, [212, 522, 730], 45);
}

// The street front, left to right.
module street_planes() {
    block(white, [-22, -38, 30], [290, 4, 660]);
    block(grey, [-45, -75, -4], [160, -30, 240]);
    block(glass, [205, -42, 330], [262, -30, 560]);
    block(black, [196, -46, 322], [206, -28, 568]);
    block(black, [261, -46, 322], [271, -28, 568]);
    block(grey, [624, -26, -3], [800, 4, 290]);
    block(white, [690, -34, 276], [1024, 4, 352]);
    block(red, [600, -44, 264], [1046, -30, 279]);
    block(blue, [300, -62, 36], [460, 6, 47]);
    block(black, [280, -10, -2], [470, 8, 34]);
}

module street_balcony() {
    block(light, [270, -182, 284], [704, 6, 303]);
    block(white, [250, -190, 258], [640, -168, 392]);
    block(grey, [274, -176, 296], [294, 3, 362]);
    rail_x(black, [254, -179, 430], 446);
    rail_x(black, [630, -179, 352], 70);
    for (x = [262, 446, 630])
        upright(black, [x, -179, 380], 52);
    block(yellow, [692, -196, -6], [708, -180, 640]);
    block(black, [694, -192, 588], [706, 20, 602]);

    block(glass, [300, -5, 302], [690, 5, 556]);
    for (x = [300, 396, 492, 588, 681])
        block(black, [x, -11, 300], [x + 10, 2, 562]);
    block(black, [298, -9, 498], [692, 3, 507]);
}

module street_windows() {
    block(glass, [300, -5, 110], [456, 5, 262]);
    for (x = [296, 373, 450])
        block(black, [x, -11, 106], [x + 10, 2, 266]);
    block(white, [290, -22, 97], [466, 3, 109]);

    block(glass, [808, -5, 96], [982, 5, 256]);
    for (x = [802, 890, 978])
        block(black, [x, -11, 90], [x + 10, 2, 262]);

    block(red, [486, 98, 12], [560, 118, 222]);
    block(glass, [566, 102, 60], [604, 117, 222]);
}

module corner_window() {
    block(glass, [700, 14, 340], [986, 262, 570]);
    for (x = [796, 892])
        block(black, [x, 6, 345], [x + 9, 20, 565]);
    for (y = [92, 170])
        block(black, [980, y, 345], [994, y + 9, 565]);
    block(black, [704, 8, 496], [992, 18, 505]);
    block(black, [982, 10, 494], [992, 256, 503]);
}

// The garden front, from the street corner away.
module garden_planes() {
    block(light, [994, -28, 262], [1034, 270, 340]);
    block(slate, [993, 262, -4], [1032, 422, 668]);
    block(white, [1028, 322, 66], [1052, 470, 512]);
    block(yellow, [1042, -96, 560], [1056, 316, 576]);
    block(blue, [1060, 296, -6], [1074, 310, 580]);
    block(black, [990, -3, -3], [1007, 264, 34]);
}

module garden_balcony() {
    block(light, [990, 430, 284], [1150, 704, 303]);
    block(white, [1140, 420, 256], [1162, 692, 386]);
    block(grey, [996, 690, 268], [1152, 710, 350]);
    rail_y(black, [1151, 424, 424], 276);
    for (y = [520, 694])
        upright(black, [1151, y, 340], 86);
    block(red, [1144, 407, -6], [1160, 424, 606]);
    block(blue, [980, 408, 590], [1172, 420, 604]);

    block(glass, [910, 440, 302], [928, 690, 566]);
    for (y = [522, 600])
        block(black, [924, y, 298], [936, y + 10, 565]);
    block(black, [922, 445, 500], [934, 685, 509]);
}

module garden_windows() {
    block(glass, [995, 34, 96], [1005, 244, 252]);
    for (y = [30, 132, 238])
        block(black, [998, y, 90], [1011, y + 10, 258]);
    block(white, [996, 24, 84], [1022, 252, 95]);
    block(black, [994, 520, 10], [1007, 604, 236]);
    block(glass, [995, 618, 90], [1004, 688, 240]);
}

module back() {
    block(glass, [560, 695, 320], [900, 705, 540]);
    for (x = [556, 725, 896])
        block(black, [x, 698, 314], [x + 10, 711, 546]);
}

grounds();
body();
roof();
street_planes();
street_balcony();
street_windows();
corner_window();
garden_planes();
garden_balcony();
garden_windows();
back();
