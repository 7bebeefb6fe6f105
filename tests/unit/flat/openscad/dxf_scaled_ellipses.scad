import("../drawings/entities.dxf", origin = [3, 4], scale = 1.5, $fn = 30);
