#pragma once

#include <algorithm>
#include <cstdint>

namespace csgsim::sim {

/// Pixels [x0, x1) x [y0, y1) of an array.
struct Rect {
  std::uint32_t x0 = 0;
  std::uint32_t y0 = 0;
  std::uint32_t x1 = 0;
  std::uint32_t y1 = 0;

  [[nodiscard]] constexpr bool empty() const { return x0 >= x1 || y0 >= y1; }
  [[nodiscard]] constexpr std::uint32_t width() const { return x1 - x0; }
  [[nodiscard]] constexpr std::uint32_t height() const { return y1 - y0; }
  [[nodiscard]] constexpr std::uint64_t area() const {
    return empty() ? 0 : static_cast<std::uint64_t>(width()) * height();
  }
  constexpr bool operator==(const Rect&) const = default;
};

/// The smallest rectangle around both.
constexpr Rect hull(const Rect& a, const Rect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

constexpr Rect intersection(const Rect& a, const Rect& b) {
  const Rect common{std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
  return common.empty() ? Rect{} : common;
}

constexpr bool contains(const Rect& outer, const Rect& inner) {
  return inner.empty() ||
         (outer.x0 <= inner.x0 && outer.y0 <= inner.y0 && inner.x1 <= outer.x1 && inner.y1 <= outer.y1);
}

}  // namespace csgsim::sim
