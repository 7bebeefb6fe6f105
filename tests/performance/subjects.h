#pragma once

#include <string>

namespace csgsim::bench {

/// Models that can be made of any size, as OpenSCAD's .csg. All lie about the origin.

/// A square of so many cubes, which do not touch; the last row may be shorter.
std::string grid_of_cubes(unsigned cubes);

/// A sphere of so many fragments, less three cylinders along the axes.
std::string drilled_sphere(unsigned fragments);

/// A union of a difference of a union of ..., as deep as it has boxes, which lie all over a cube.
std::string deep_tree(unsigned boxes);

/// A plate with so many round holes, of so many facets each, whose axes are 2 apart. Of radius 1 they nearly touch each
/// other and the plate's sides.
std::string drilled_plate(unsigned holes, unsigned facets, double radius);

/// Half-spaces of the sphere: 32 fragments make 482.
unsigned sphere_halfspaces(unsigned fragments);

}  // namespace csgsim::bench
