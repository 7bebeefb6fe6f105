// Tolerances of meshes, and limits of their division into convex pieces.
// Used throughout host/solids and by host/commands.
#pragma once

#include <cstddef>

#include "host/model/limits.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// Maximum distance, in units of the largest coordinate, by which rounding may have moved a point. OpenSCAD prints 6
/// digits, which moves a coordinate by up to 5e-6 of its value. In a test of 20,000 boxes printed that way and rotated
/// and translated at random, the largest bend of a box, cut into triangles, was 1.1e-5.
inline constexpr double printed_tolerance = 2e-5;

/// Maximum distance, in units of the largest coordinate, by which rounding to single precision may have moved a point,
/// as in STL files: half a unit in the last place per coordinate; eight such errors may add up.
inline constexpr double single_precision_tolerance = 0x1p-22;

/// Maximum distance, in units of the largest coordinate, by which arithmetic in doubles may have moved a point.
inline constexpr double double_precision_tolerance = 1e-12;

/// Upper bound of tolerances, as a fraction of the mesh's size: a mesh so far from the origin that it lost more
/// precision is rejected.
inline constexpr double max_tolerance = 1e-3;

/// Upper bound of the joining distance, as a fraction of the median edge. Points farther apart were not separated by
/// rounding; without this bound a single far corner would determine the tolerance of all other corners.
inline constexpr double max_edge_fraction = 0.01;

/// Maximum magnitude of a coordinate; products of larger coordinates leave the range of doubles.
inline constexpr double max_coordinate = model::max_coordinate;

/// Limits and tolerances of the division of a solid into convex pieces.
struct Limits {
  double tolerance = printed_tolerance;  ///< distance of points from a flat face, in units of the largest coordinate
  bool checks_coverage = true;           ///< whether pieces that extend past the surface are rejected as a hole
  std::size_t max_pieces = 100'000;
  std::size_t max_fragments = 4'000'000;  ///< parts of faces produced by cuts
  Work work{};
};

}  // namespace csgsim::solids
