import("../drawings/strokes.svg");
