// The functions of a convex solid's boundary that compete at some pixel.
// Used by host/emit and sim/software.
#pragma once

#include <cstdint>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::view {

/// The linear functions that bound a convex solid in a picture. Depths are floor(value >> shift). At a pixel, the solid
/// begins at the greatest depth of the fronts and ends at the least depth of the backs; among equal depths, the first
/// function counts. The solid is present if it begins before it ends and no edge is negative.
struct Boundary {
  std::vector<FixedLinear> fronts;
  std::vector<FixedLinear> backs;
  std::vector<FixedLinear> edges;
};

/// The functions of a Boundary that compete with one of its fronts or backs, as indices in ascending order.
struct Rivals {
  std::vector<std::uint32_t> fronts;
  std::vector<std::uint32_t> backs;
  std::vector<std::uint32_t> edges;
  PixelRect pixels{};  ///< outside these pixels, the solid neither begins nor ends with this function
};

struct AllRivals {
  std::vector<Rivals> of_fronts;  ///< one per front
  std::vector<Rivals> of_backs;   ///< one per back
};

/// The rivals of each front and back. They suffice to decide, at every pixel of the rectangle, whether the solid begins
/// or ends with this function; the function at the other end of the solid there is also among the rivals.
///
/// The rectangle is halved until few functions lead somewhere in a part. If faces are spread over the picture, this
/// takes n log n steps, and each face has few rivals.
AllRivals rivals(const Boundary& boundary, const PixelRect& pixels, unsigned shift);

}  // namespace csgsim::view
