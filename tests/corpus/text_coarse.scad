// $fn tells how many pieces a curve of a letter gets.
linear_extrude(2) text("SO", size = 12, font = "DejaVu Sans", $fn = 2);
translate([0, 16]) linear_extrude(3) text("SO", size = 12, font = "DejaVu Sans", $fn = 20);
translate([0, 32]) linear_extrude(4) text("SO", size = 12, font = "DejaVu Sans", $fs = 0.2);
