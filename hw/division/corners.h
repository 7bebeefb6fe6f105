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

/// A half-space of a primitive, with its plane.
struct PlacedHalfspace {
  std::uint32_t primitive = 0;
  std::uint32_t number = 0;  ///< among the primitive's
  Halfspace halfspace;
  Plane plane;
};

/// A half-space held against the four corners of a rectangle, where a plane has its extremes.
struct Tested : PlacedHalfspace {
  Side side = Side::front;
  std::array<std::int64_t, 4> corners{};  ///< the plane's values, with their fraction
  std::int64_t low = 0;                   ///< the least F over the pixels; see Side
  std::int64_t high = 0;                  ///< the greatest
};

/// One corner test: four values A*x + B*y + C, the least and the greatest of them.
Tested test_corners(const ModelHeader& header, const PlacedHalfspace& placed, const Rectangle& pixels);

/// Whether every point, or none, of the rectangle that was tested and of the depths is in the half-space.
Known known_between(const Tested& tested, std::int64_t z_low, std::int64_t z_high);

}  // namespace csgsim::division
