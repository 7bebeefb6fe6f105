import("../drawings/met.svg", dpi = 96);
