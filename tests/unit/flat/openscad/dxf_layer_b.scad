import("../drawings/blocks.dxf", layer = "b", scale = 0.5);
