import("../drawings/transforms.svg");
