#include "host/view/region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace csgsim::view {

namespace {

double value(const FixedLinear& linear, const glm::dvec2& at) {
  return static_cast<double>(linear.a) * at.x + static_cast<double>(linear.b) * at.y + static_cast<double>(linear.c);
}

/// Bound of the error of a function evaluated in doubles at corners that are rounded themselves: 2^-44 of its largest
/// term, a few hundred times the rounding error of that term.
double error_bound(const FixedLinear& linear, double reach) {
  const double largest = (std::abs(static_cast<double>(linear.a)) + std::abs(static_cast<double>(linear.b))) * reach +
                         std::abs(static_cast<double>(linear.c));
  return std::ldexp(largest, -44);
}

}  // namespace

Region::Region(const PixelRect& pixels) {
  if (pixels.empty()) return;
  corners_ = {{pixels.x0, pixels.y0}, {pixels.x1, pixels.y0}, {pixels.x1, pixels.y1}, {pixels.x0, pixels.y1}};
  reach_ = 1.0 + std::max({std::abs(pixels.x0), std::abs(pixels.x1), std::abs(pixels.y0), std::abs(pixels.y1)});
}

bool Region::is_certainly_at_least(const FixedLinear& linear, double minimum) const {
  const double sure = minimum + error_bound(linear, reach_);
  return std::ranges::all_of(corners_, [&](const glm::dvec2& corner) { return value(linear, corner) >= sure; });
}

std::pair<double, double> Region::range(const FixedLinear& linear) const {
  std::pair<double, double> range{value(linear, corners_.front()), value(linear, corners_.front())};
  for (const glm::dvec2& corner : corners_) {
    const double here = value(linear, corner);
    range = {std::min(range.first, here), std::max(range.second, here)};
  }
  return range;
}

bool Region::clip(const FixedLinear& linear, double minimum) {
  if (is_certainly_at_least(linear, minimum)) return true;
  const double low = -error_bound(linear, reach_);
  clipped_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const glm::dvec2& here = corners_[i];
    const glm::dvec2& next = corners_[(i + 1) % corners_.size()];
    const double at_here = value(linear, here) - low;
    const double at_next = value(linear, next) - low;
    if (at_here >= 0.0) clipped_.push_back(here);
    if ((at_here >= 0.0) != (at_next >= 0.0))
      clipped_.push_back(here + (next - here) * (at_here / (at_here - at_next)));
  }
  std::swap(corners_, clipped_);
  return false;
}

PixelRect Region::pixels() const {
  if (corners_.empty()) return {};
  glm::dvec2 low = corners_.front();
  glm::dvec2 high = low;
  for (const glm::dvec2& corner : corners_) {
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  constexpr double near = 0x1p-20;
  return {static_cast<std::int32_t>(std::ceil(low.x - near)), static_cast<std::int32_t>(std::ceil(low.y - near)),
          static_cast<std::int32_t>(std::floor(high.x + near)), static_cast<std::int32_t>(std::floor(high.y + near))};
}

}  // namespace csgsim::view
