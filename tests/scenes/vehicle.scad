// The terrain vehicle on the ground, with a pane in its windscreen.
//
// Licence: MIT, the csgsim authors.

include <../models/terrain_vehicle.scad>

color([0.55, 0.75, 0.80, 0.35])
    translate([49, 0, 98]) rotate([0, -14, 0]) translate([1.5, -56, 6]) cube([1, 112, 35]);
color([0.72, 0.66, 0.55]) translate([-230, -190, -3]) cube([470, 380, 3]);
