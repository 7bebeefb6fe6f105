#include "host/effects/outline.h"

#include <algorithm>
#include <cmath>

namespace csgsim::effects {

namespace {

/// What doubles may lose, relative to the greatest terms of a line's value and to a picture's side.
constexpr double noise = 1e-11;
constexpr double greatest_side = 1 << 16;

struct Line {
  explicit Line(const view::FixedLinear& line)
      : a(static_cast<double>(line.a)), b(static_cast<double>(line.b)), c(static_cast<double>(line.c)) {}

  /// Above 0 where it may be 0 or more.
  [[nodiscard]] double at(const glm::dvec2& place) const {
    const double x = a * place.x;
    const double y = b * place.y;
    return x + y + c + noise * (std::abs(x) + std::abs(y) + std::abs(c) + std::abs(a) + std::abs(b));
  }

  double a;
  double b;
  double c;
};

}  // namespace

Outline::Outline(const view::PixelRect& pixels) {
  if (pixels.empty()) return;
  corners_ = {{pixels.x0, pixels.y0}, {pixels.x1, pixels.y0}, {pixels.x1, pixels.y1}, {pixels.x0, pixels.y1}};
}

Outline Outline::clipped(const view::FixedLinear& fixed) const {
  const Line line(fixed);
  Outline left;
  if (empty()) return left;
  left.corners_.reserve(corners_.size() + 1);
  const double value_first = line.at(corners_.front());
  double value = value_first;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const bool is_last = i + 1 == corners_.size();
    const glm::dvec2& here = corners_[i];
    const glm::dvec2& next = is_last ? corners_.front() : corners_[i + 1];
    const double value_next = is_last ? value_first : line.at(next);
    if (value >= 0) left.corners_.push_back(here);
    if ((value >= 0) != (value_next >= 0))
      left.corners_.push_back(here + (next - here) * (value / (value - value_next)));
    value = value_next;
  }
  return left;
}

bool Outline::is_beyond(const view::FixedLinear& fixed) const {
  const Line line(fixed);
  return std::none_of(corners_.begin(), corners_.end(), [&](const glm::dvec2& one) { return line.at(one) >= 0; });
}

view::PixelRect Outline::pixels() const {
  view::PixelRect all;
  for (const glm::dvec2& corner : corners_) {
    const glm::dvec2 place = glm::dvec2(std::clamp(corner.x, -greatest_side, greatest_side),
                                        std::clamp(corner.y, -greatest_side, greatest_side));
    all =
        view::hull(all, {static_cast<std::int32_t>(std::floor(place.x)), static_cast<std::int32_t>(std::floor(place.y)),
                         static_cast<std::int32_t>(std::ceil(place.x)), static_cast<std::int32_t>(std::ceil(place.y))});
  }
  return all;
}

}  // namespace csgsim::effects
