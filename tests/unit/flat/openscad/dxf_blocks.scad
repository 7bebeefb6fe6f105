import("../drawings/blocks.dxf");
