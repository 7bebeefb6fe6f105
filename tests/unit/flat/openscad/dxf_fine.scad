import("../drawings/entities.dxf", $fn = 24);
