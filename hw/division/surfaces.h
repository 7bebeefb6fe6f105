#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/candidates.h"
#include "hw/division/corners.h"
#include "hw/division/datapath.h"
#include "hw/division/display_model.h"

namespace csgsim::division {

/// What may be drawn in a square as one convex solid: a primitive, or several that are joined.
struct Surface {
  std::uint32_t first = 0;  ///< the first primitive
  std::uint32_t count = 0;
  bool complemented = false;
  std::uint32_t near_colour = 0;  ///< of the first primitive
  Box box;                        ///< the pixels and depths of the square that the surface can be in
  std::vector<Tested> tested;     ///< the half-spaces of all of them, at the corners of the box's pixels

  [[nodiscard]] bool holds(std::uint32_t primitive) const { return primitive >= first && primitive - first < count; }
};

/// Looks at those `count` primitives: their surface, not tested yet, in the part of the square that all their boxes
/// have in common. Without a box there is none.
Surface look_at_boxes(Datapath& path, const Candidates& candidates, std::uint32_t first, std::uint32_t count,
                      const Rectangle& square);

/// Tests the half-spaces of the surface. False unless they leave some depth at the corners (fronts the least, backs the
/// greatest).
bool test(Datapath& path, const Candidates& candidates, Surface& surface);

/// Those of one side that make the surface over all depths.
struct Extremes {
  std::vector<Tested> facets;
  bool nothing = false;  ///< one of them holds nothing
};

/// Of a surface over all depths, or of a primitive between those of a surface that it is compared with. The half-spaces
/// have been tested at the corners of the box's pixels.
Extremes extremes_of(Datapath& path, const std::vector<Tested>& tested, Side side, const Box& box);

}  // namespace csgsim::division
