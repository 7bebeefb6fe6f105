import("../drawings/met.svg");
