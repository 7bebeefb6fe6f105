import("../drawings/pixels.svg");
