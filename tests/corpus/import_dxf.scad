// A drawing's layers: lines, arcs, circles, an ellipse and a polyline; all of them, one of them moved and scaled.
linear_extrude(2) import("data/shapes.dxf");
translate([0, 24]) linear_extrude(4) import("data/shapes.dxf", layer = "slot", origin = [8, 8], scale = 1.5);
translate([30, 24]) linear_extrude(6) import("data/shapes.dxf", layer = "holes", $fn = 12);
