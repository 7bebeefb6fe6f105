#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/candidates.h"
#include "hw/division/corners.h"
#include "hw/division/datapath.h"
#include "hw/division/display_model.h"

namespace csgsim::division {

/// A convex solid that may be drawn in a square: one primitive, or several primitives that are drawn as one.
struct Surface {
  std::uint32_t first = 0;  ///< first primitive
  std::uint32_t count = 0;
  bool complemented = false;
  std::uint32_t near_colour = 0;        ///< colour of the first primitive
  Box box;                              ///< pixels and depths of the square that the surface can occupy
  std::vector<TestedHalfspace> tested;  ///< half-spaces of all its primitives, tested at the corners of the box

  [[nodiscard]] bool holds(std::uint32_t primitive) const { return primitive >= first && primitive - first < count; }
};

/// Visits `count` primitives from `first` on. Returns their surface, not yet tested, in the part of the square that is
/// common to all their boxes; if the box is empty, there is no surface.
Surface intersect_boxes(Datapath& path, const Candidates& candidates, std::uint32_t first, std::uint32_t count,
                        const Rectangle& square);

/// Tests the half-spaces of the surface at the corners. Returns whether some depth remains there between the minimum of
/// the fronts and the maximum of the backs.
bool test(Datapath& path, const Candidates& candidates, Surface& surface);

/// Facets of one side that form the surface.
struct Extremes {
  std::vector<TestedHalfspace> facets;
  bool is_empty = false;  ///< true if one of the half-spaces contains no point
};

/// The facets of one side of a surface over all depths, or of a primitive within the depths of the surface with which
/// it is compared. The half-spaces must have been tested at the corners of the box.
Extremes find_extremes(Datapath& path, const std::vector<TestedHalfspace>& tested, Side side, const Box& box);

}  // namespace csgsim::division
