import("../drawings/layers.dxf");
