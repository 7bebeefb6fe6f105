#pragma once

#include <cstdint>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::view {

/// The linear functions that bound a convex solid in a picture. Depths are values >> shift, floor. At a pixel the
/// greatest depth of the fronts is where the solid begins, the least of the backs where it ends, of equal ones the
/// first; it is there if it begins before it ends and no edge is below 0.
struct Boundary {
  std::vector<FixedLinear> fronts;
  std::vector<FixedLinear> backs;
  std::vector<FixedLinear> edges;
};

/// Functions of a Boundary that one of its fronts or backs is held against, by their numbers, ascending.
struct Rivals {
  std::vector<std::uint32_t> fronts;
  std::vector<std::uint32_t> backs;
  std::vector<std::uint32_t> edges;
  PixelRect pixels{};  ///< outside of these it is not where the solid begins or ends
};

struct AllRivals {
  std::vector<Rivals> of_fronts;  ///< one a front
  std::vector<Rivals> of_backs;   ///< one a back
};

/// The rivals of each front and back, so many that at every pixel of the rectangle it is where the solid begins, or
/// ends, if that is so of it and its rivals alone; there the solid's other end is one of them.
///
/// The rectangle is halved until few functions are left that lead somewhere in a part. Where faces are spread over the
/// picture this takes n log n steps, and each has few rivals.
AllRivals rivals(const Boundary& boundary, const PixelRect& pixels, unsigned shift);

}  // namespace csgsim::view
