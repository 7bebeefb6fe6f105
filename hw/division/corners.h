#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/division/display_model.h"

namespace csgsim::division {

/// What is known of something over pixels and depths.
enum class Known : std::uint8_t { out, in, depends };

constexpr Known inverted(Known known) {
  if (known == Known::depends) return known;
  return known == Known::in ? Known::out : Known::in;
}

/// A half-space held against the four corners of a rectangle, where a plane has its extremes.
struct Tested {
  std::uint32_t primitive = 0;
  Halfspace halfspace;
  Side side = Side::front;
  std::array<std::int64_t, 4> corners{};  ///< the plane's values, with their fraction
  std::int64_t low = 0;                   ///< the least F over the pixels; see Side
  std::int64_t high = 0;                  ///< the greatest
};

/// One corner test: four values A*x + B*y + C, the least and the greatest of them.
Tested test_corners(const DisplayModel& model, std::uint32_t primitive, const Halfspace& halfspace,
                    const Rectangle& pixels);

/// Whether every point, or none, of the rectangle that was tested and of the depths is in the half-space.
Known known_between(const Tested& tested, std::int64_t z_low, std::int64_t z_high);

// What the half-spaces of one side of a convex solid leave of each other, by the rules of thesis table 7.1 and figure
// 7.5: the front of an intersection is where its planes are farthest (convex-max), its back where they are nearest
// (concave-min). A half-space that another one is beyond at all four corners, by `step`, that is a whole depth step, is
// beyond nowhere between them, and makes no part of the surface. All of a side have to be fronts, or all backs.

/// Keeps those that none of the four leaders is beyond: the extreme at each corner, the first of equals.
void keep_by_leaders(std::vector<Tested>& side, std::int64_t step);

/// Then keeps those of them that no other one is beyond. Returns the pairs that are held against each other:
/// k (k - 1) / 2 for k that the leaders leave.
std::uint64_t keep_extremes(std::vector<Tested>& side, std::int64_t step);

}  // namespace csgsim::division
