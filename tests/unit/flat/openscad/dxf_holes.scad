import("../drawings/layers.dxf", layer = "holes");
