#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/division/display_model.h"

namespace csgsim::division {

/// Position of an object relative to a range of pixels and depths.
enum class Containment : std::uint8_t { out, in, depends };

constexpr Containment inverted(Containment known) {
  if (known == Containment::depends) return known;
  return known == Containment::in ? Containment::out : Containment::in;
}

/// A half-space of a primitive, with its plane.
struct PlacedHalfspace {
  std::uint32_t primitive = 0;
  std::uint32_t number = 0;  ///< index within the primitive
  Halfspace halfspace;
  Plane plane;
};

/// A half-space tested at the four corners of a rectangle, where a plane has its extremes.
struct TestedHalfspace : PlacedHalfspace {
  Side side = Side::front;
  std::array<std::int64_t, 4> corners{};  ///< values of the plane, including the fraction
  std::int64_t low = 0;                   ///< minimum of F over the pixels; see Side
  std::int64_t high = 0;                  ///< maximum of F over the pixels
};

/// One corner test: four values A*x + B*y + C, and their minimum and maximum.
TestedHalfspace test_corners(const ModelHeader& header, const PlacedHalfspace& placed, const Rectangle& pixels);

/// Whether a half-space contains all points of the tested rectangle between the two depths, none, or some.
Containment classify_between(const TestedHalfspace& tested, std::int64_t z_low, std::int64_t z_high);

}  // namespace csgsim::division
