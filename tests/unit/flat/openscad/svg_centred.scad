import("../drawings/stretched.svg", center = true);
