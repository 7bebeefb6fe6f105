import("../drawings/entities.dxf");
