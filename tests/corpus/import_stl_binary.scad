// A binary STL file, whose header begins as if it were ASCII: a torus.
import("data/torus.stl", convexity = 4);
