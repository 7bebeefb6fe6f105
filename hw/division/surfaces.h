#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/division/candidates.h"
#include "hw/division/corners.h"
#include "hw/division/counts.h"
#include "hw/division/display_model.h"

namespace csgsim::division {

/// What may be drawn in a square as one convex solid: a primitive, or several that are joined.
struct Surface {
  std::uint32_t first;  ///< the first primitive
  std::uint32_t count;
  Box box;                     ///< the pixels and depths of the square that the surface can be in
  std::vector<Tested> tested;  ///< the half-spaces of all of them, at the corners of the box's pixels

  [[nodiscard]] bool holds(std::uint32_t primitive) const { return primitive >= first && primitive - first < count; }
};

/// How many primitives are joined from `first` on, itself included.
std::uint32_t joined_from(const DisplayModel& model, std::uint32_t first);

/// The surface of those `count` primitives if it can be in the square: their boxes have something in common with it and
/// each other, and their half-spaces leave some depth at the corners (fronts the least, backs the greatest).
std::optional<Surface> surface_in(const DisplayModel& model, const Candidates& candidates, std::uint32_t first,
                                  std::uint32_t count, const Rectangle& square, Counts& counts);

/// Those of one side that make the surface over all depths.
struct Extremes {
  std::vector<Tested> facets;
  bool nothing = false;  ///< one of them holds nothing
};

/// Of a surface over all depths, or of a primitive between those of a surface that it is compared with. The half-spaces
/// have been tested at the corners of the box's pixels.
Extremes extremes_of(const DisplayModel& model, const std::vector<Tested>& tested, Side side, const Box& box,
                     Counts& counts);

}  // namespace csgsim::division
