import("../drawings/percent.svg");
