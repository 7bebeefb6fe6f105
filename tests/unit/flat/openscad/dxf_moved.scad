import("../drawings/blocks.dxf", origin = [5, -3], scale = 2.5);
