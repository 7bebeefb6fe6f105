#pragma once

#include <algorithm>
#include <cstdint>

#include "hw/isa/program.h"

namespace csgsim::division {

/// Pixels [x0, x1] x [y0, y1] of the picture; row 0 is at the top.
struct Rectangle {
  std::int32_t x0 = 0;
  std::int32_t y0 = 0;
  std::int32_t x1 = -1;
  std::int32_t y1 = -1;

  [[nodiscard]] constexpr bool empty() const { return x0 > x1 || y0 > y1; }
  constexpr bool operator==(const Rectangle&) const = default;
};

constexpr Rectangle overlap(const Rectangle& a, const Rectangle& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

constexpr Rectangle rectangle_of(const isa::Region& region) {
  const auto x = static_cast<std::int32_t>(region.x);
  const auto y = static_cast<std::int32_t>(region.y);
  return {x, y, x + static_cast<std::int32_t>(region.width) - 1, y + static_cast<std::int32_t>(region.height) - 1};
}

/// A rectangle of pixels and the range of depth steps [z_low, z_high].
struct Box {
  Rectangle pixels;
  std::int64_t z_low = 0;
  std::int64_t z_high = -1;

  [[nodiscard]] constexpr bool empty() const { return pixels.empty() || z_low > z_high; }
  constexpr bool operator==(const Box&) const = default;
};

/// Whether two boxes do not overlap.
constexpr bool are_disjoint(const Box& a, const Box& b) {
  return overlap(a.pixels, b.pixels).empty() || a.z_low > b.z_high || b.z_low > a.z_high;
}

}  // namespace csgsim::division
