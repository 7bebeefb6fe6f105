import("../drawings/paths.svg");
