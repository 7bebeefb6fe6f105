#pragma once

#include <cstddef>

#include "host/model/limits.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// How far, in units of the largest coordinate, rounding may have moved a point. OpenSCAD prints 6 digits, which moves
/// a coordinate by up to 5e-6 of itself; of 20,000 boxes printed so, turned and moved at random, the worst, cut into
/// triangles, was bent by 1.1e-5.
inline constexpr double printed_tolerance = 2e-5;

/// The same of single precision, as in STL files: half a last place a coordinate, of which eight may add up.
inline constexpr double single_precision_tolerance = 0x1p-22;

/// What is left by the rounding of doubles.
inline constexpr double double_precision_tolerance = 1e-12;

/// What has lost more than this part of its size, far from the origin, is not to be trusted.
inline constexpr double largest_tolerance = 1e-3;

/// Points that are apart by more than this part of an edge of the middle length are not what rounding has moved: a
/// corner far from all others would make the tolerance that of its own coordinates.
inline constexpr double largest_part_of_edge = 0.01;

/// Farther from the origin, products of coordinates leave the range of doubles.
inline constexpr double most_coordinate = model::most_coordinate;

/// How a solid is cut into convex pieces.
struct Limits {
  double tolerance = printed_tolerance;  ///< how far points may be off a flat face, in units of the largest coordinate
  bool watches_cover = true;             ///< pieces that have grown past the surface are a hole
  std::size_t most_pieces = 100'000;
  std::size_t most_fragments = 4'000'000;  ///< parts of faces that cuts have made
  Work work{};
};

}  // namespace csgsim::solids
