import("../drawings/unsized.svg");
