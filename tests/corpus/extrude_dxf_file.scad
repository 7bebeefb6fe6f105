// linear_extrude and rotate_extrude of a drawing's layer, as old files have it: without a child.
linear_extrude(file = "data/shapes.dxf", layer = "plate", height = 3);
translate([0, 22, 0]) linear_extrude(file = "data/shapes.dxf", layer = "slot", height = 5, origin = [8, 8], twist = 40, slices = 5, $fn = 12);
translate([56, 12, 0]) rotate_extrude(file = "data/shapes.dxf", layer = "holes", origin = [20, 0], $fn = 20);
