import("../drawings/layers.dxf", layer = "plate");
