#pragma once

#include <string>

namespace csgsim::bench {

/// Models of any size, as OpenSCAD's .csg. All are centred at the origin.

/// A square grid of `cubes` cubes, which do not touch; the last row may be shorter.
std::string grid_of_cubes(unsigned cubes);

/// A sphere with that number of fragments, minus three cylinders along the axes.
std::string drilled_sphere(unsigned fragments);

/// A union of a difference of a union of ..., as deep as its number of boxes, which are spread over a cube.
std::string deep_tree(unsigned boxes);

/// A plate with round holes of `facets` facets each, at a distance of 2. With radius 1 they nearly touch each other and
/// the plate's sides.
std::string drilled_plate(unsigned holes, unsigned facets, double radius);

/// Number of half-spaces of the sphere: 32 fragments give 482.
unsigned sphere_halfspaces(unsigned fragments);

}  // namespace csgsim::bench
