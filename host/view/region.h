#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::view {

/// A convex polygon of the picture that holds every pixel of a rectangle at which some linear functions of integers are
/// at least 0, and no more than rounding makes it.
class Region {
 public:
  explicit Region(const PixelRect& pixels);

  /// Leaves what the function is not surely below 0 at. Returns whether it is surely at least `least`, of 0 and more,
  /// at all pixels that were left, so that nothing is taken away.
  bool clip(const FixedLinear& linear, double least = 0);
  /// Whether the function is surely at least that everywhere.
  [[nodiscard]] bool is_surely_at_least(const FixedLinear& linear, double least) const;

  /// Its least and greatest value there, as near as doubles are. Not of an empty region.
  [[nodiscard]] std::pair<double, double> range(const FixedLinear& linear) const;

  [[nodiscard]] bool empty() const { return corners_.empty(); }
  [[nodiscard]] std::span<const glm::dvec2> corners() const { return corners_; }
  /// The pixels of the polygon.
  [[nodiscard]] PixelRect pixels() const;

 private:
  std::vector<glm::dvec2> corners_;
  std::vector<glm::dvec2> clipped_;
  double reach_ = 0;  ///< how far from the first pixel of the picture its pixels are
};

}  // namespace csgsim::view
