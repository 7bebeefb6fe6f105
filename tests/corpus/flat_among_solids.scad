// A flat shape beside solids: OpenSCAD leaves it out, here and in a difference.
cube([8, 8, 3]);
translate([4, 4]) square(20);
translate([12, 0, 0]) difference() { cube(8); translate([2, 2]) square(4); }
