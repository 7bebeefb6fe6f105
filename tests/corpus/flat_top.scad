// Flat shapes alone: shown as plates.
difference() { circle(10); translate([3, 2]) square(6); }
translate([12, -8]) text("2-D", size = 8, font = "DejaVu Sans");
