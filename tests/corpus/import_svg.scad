// Shapes of an SVG file: plain ones, a group that is moved and turned, a path with a hole.
linear_extrude(3) import("data/shapes.svg");
