// A drawing with a block that is placed three times: moved, scaled, turned.
linear_extrude(3) import("data/blocks.dxf");
