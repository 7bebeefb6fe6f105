#include "host/effects/outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace csgsim::effects {

namespace {

/// Bound of rounding errors in double precision, relative to the greatest terms of a line's value and to the picture's
/// side.
constexpr double noise = 1e-11;
constexpr double greatest_side = 1 << 16;

struct Line {
  explicit Line(const view::FixedLinear& line)
      : a(static_cast<double>(line.a)), b(static_cast<double>(line.b)), c(static_cast<double>(line.c)) {}

  /// Upper bound of the line's value: positive wherever the value may be 0 or more.
  [[nodiscard]] double at(const glm::dvec2& place) const {
    const double x = a * place.x;
    const double y = b * place.y;
    return x + y + c + noise * (std::abs(x) + std::abs(y) + std::abs(c) + std::abs(a) + std::abs(b));
  }

  /// Lower bound of the line's value.
  [[nodiscard]] double min_at(const glm::dvec2& place) const {
    const double x = a * place.x;
    const double y = b * place.y;
    return x + y + c - 4 * noise * (std::abs(x) + std::abs(y) + std::abs(c) + std::abs(a) + std::abs(b));
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
  Outline left = *this;
  Outline spare;
  left.clip(fixed, spare);
  return left;
}

bool Outline::clip(const view::FixedLinear& fixed, Outline& spare) {
  if (empty()) return false;
  const Line line(fixed);
  const auto is_in = [&](const glm::dvec2& corner) { return line.at(corner) >= 0; };
  const bool starts_in = is_in(corners_.front());
  const auto other = std::find_if(corners_.begin() + 1, corners_.end(),
                                  [&](const glm::dvec2& corner) { return is_in(corner) != starts_in; });
  if (other == corners_.end()) {
    if (!starts_in) corners_.clear();
    return starts_in;
  }
  std::vector<glm::dvec2>& left = spare.corners_;
  left.clear();
  const double value_first = line.at(corners_.front());
  double value = value_first;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const bool is_last = i + 1 == corners_.size();
    const glm::dvec2& here = corners_[i];
    const glm::dvec2& next = is_last ? corners_.front() : corners_[i + 1];
    const double value_next = is_last ? value_first : line.at(next);
    if (value >= 0) left.push_back(here);
    if ((value >= 0) != (value_next >= 0)) left.push_back(here + (next - here) * (value / (value - value_next)));
    value = value_next;
  }
  std::swap(corners_, left);
  return true;
}

Outline::Position Outline::position(const view::FixedLinear& fixed, double minimum) const {
  const Line line(fixed);
  bool is_beyond = true;
  bool is_within = true;
  for (const glm::dvec2& corner : corners_) {
    is_beyond = is_beyond && !(line.at(corner) >= 0);
    is_within = is_within && line.min_at(corner) >= minimum;
    if (!is_beyond && !is_within) return Position::across;
  }
  return is_beyond ? Position::beyond : Position::within;
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
