import("../drawings/sliced.svg");
