// Two involute spur gears of module 2 with 13 and 22 teeth, in mesh on a plate with posts and screw holes.
module_ = 2;
pressure = 20;

function involute(r, t) = r * [cos(t) + t * PI / 180 * sin(t), sin(t) - t * PI / 180 * cos(t)];
function turn(p, a) = [p[0] * cos(a) - p[1] * sin(a), p[0] * sin(a) + p[1] * cos(a)];
function mirrored(points) = [for (i = [len(points) - 1:-1:0]) [points[i][0], -points[i][1]]];

// One tooth about the x axis: the flanks are involutes of the base circle, from the root to the tip.
module tooth(teeth) {
  pitch = module_ * teeth / 2;
  base = pitch * cos(pressure);
  tip = pitch + module_;
  last = sqrt(pow(tip / base, 2) - 1) * 180 / PI;
  at_pitch = sqrt(pow(pitch / base, 2) - 1) * 180 / PI;
  p = involute(base, at_pitch);
  half = 90 / teeth * 0.97 + atan2(p[1], p[0]);
  flank = [for (i = [0:5]) turn(involute(base, last * i / 5), -half)];
  polygon(concat([turn([pitch - 2 * module_, 0], -half)], flank, mirrored(flank), [turn([pitch - 2 * module_, 0], half)]));
}

module gear(teeth, width, bore) {
  pitch = module_ * teeth / 2;
  difference() {
    linear_extrude(width) difference() {
      union() {
        circle(pitch - 1.2 * module_, $fn = 3 * teeth);
        for (i = [0:teeth - 1]) rotate(360 * i / teeth) tooth(teeth);
      }
      circle(bore, $fn = 32);
    }
    translate([0, 0, width - 1.5]) rotate_extrude($fn = 48) translate([bore + 3, 0]) square([pitch - bore - 7.5, 5]);
    if (teeth > 16) for (i = [0:4]) rotate(72 * i + 18) translate([pitch * 0.57, 0, -1]) cylinder(h = 20, r = 4, $fn = 24);
  }
}

apart = module_ * (13 + 22) / 2;
color("goldenrod") translate([0, 0, 6]) gear(22, 8, 4);
color("lightsteelblue") translate([apart, 0, 6]) rotate(180 / 13) gear(13, 8, 4);

color("gray") translate([-28, -25, 0]) difference() {
  linear_extrude(5) offset(r = 6, $fn = 32) square([apart + 48, 50], center = false);
  for (x = [0, apart + 48], y = [0, 50]) translate([x, y, -1]) { cylinder(h = 9, r = 1.7, $fn = 20); translate([0, 0, 4]) cylinder(h = 2.1, r1 = 1.7, r2 = 3.6, $fn = 24); }
  translate([apart + 16, 1, 4.2]) linear_extrude(2) text("m 2   13 : 22", size = 5.5, font = "DejaVu Sans:style=Bold", halign = "center", valign = "center");
}
color("dimgray") for (x = [0, apart]) translate([x, 0, 0]) {
  cylinder(h = 16, r = 3.8, $fn = 32);
  cylinder(h = 5.8, r = 7, $fn = 32);
}
