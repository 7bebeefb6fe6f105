import("../drawings/stretched.svg");
