import("../drawings/others.svg");
