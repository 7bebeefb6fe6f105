// An ASCII STL file: a star's prism; turned, sheared and mirrored.
import("data/star.stl");
translate([24, 0, 0]) multmatrix([[1, 0.3, 0, 0], [0, -1, 0.2, 0], [0, 0, 2, 0]]) import("data/star.stl");
