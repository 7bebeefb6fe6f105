import("../drawings/exported.dxf");
