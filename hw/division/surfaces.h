#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/candidates.h"
#include "hw/division/corners.h"
#include "hw/division/datapath.h"
#include "hw/division/display_model.h"

namespace csgsim::division {

/// A convex solid that may be drawn in a square: one primitive, or several joined ones.
struct Surface {
  std::uint32_t first = 0;  ///< first primitive
  std::uint32_t count = 0;
  bool complemented = false;
  std::uint32_t near_colour = 0;  ///< colour of the first primitive
  Box box;                        ///< pixels and depths of the square that the surface can occupy
  std::vector<Tested> tested;     ///< half-spaces of all its primitives, tested at the corners of the box's pixels

  [[nodiscard]] bool holds(std::uint32_t primitive) const { return primitive >= first && primitive - first < count; }
};

/// Visits those `count` primitives. Returns their surface, not tested yet, in the part of the square that is common to
/// all their boxes; an empty box means no surface.
Surface intersect_boxes(Datapath& path, const Candidates& candidates, std::uint32_t first, std::uint32_t count,
                        const Rectangle& square);

/// Tests the half-spaces of the surface. Returns whether they leave a nonempty depth range at the corners (between the
/// minimum of the fronts and the maximum of the backs).
bool test(Datapath& path, const Candidates& candidates, Surface& surface);

/// Facets of one side that form the surface over all depths.
struct Extremes {
  std::vector<Tested> facets;
  bool is_empty = false;  ///< one of them contains nothing
};

/// Extremes of a surface over all depths, or of a primitive within the depths of the surface that it is compared with.
/// The half-spaces must have been tested at the corners of the box's pixels.
Extremes extremes_of(Datapath& path, const std::vector<Tested>& tested, Side side, const Box& box);

}  // namespace csgsim::division
