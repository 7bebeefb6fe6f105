import("../drawings/shapes.svg");
