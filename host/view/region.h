// Convex regions of the picture, clipped by linear functions.
// Used by host/emit and sim/software.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::view {

/// A convex polygon in the picture that contains every pixel of a rectangle at which the given integer linear functions
/// are at least 0. It is as small as rounding allows.
class Region {
 public:
  explicit Region(const PixelRect& pixels);

  /// Removes the part in which the function is certainly negative. Returns whether the function is certainly at least
  /// `minimum` (0 or more) at all pixels of the region, so that nothing was removed.
  bool clip(const FixedLinear& linear, double minimum = 0);
  /// Whether the function is certainly at least `minimum` everywhere in the region.
  [[nodiscard]] bool is_certainly_at_least(const FixedLinear& linear, double minimum) const;

  /// Minimum and maximum of the function in the region, in double precision. The region must not be empty.
  [[nodiscard]] std::pair<double, double> range(const FixedLinear& linear) const;

  [[nodiscard]] bool empty() const { return corners_.empty(); }
  [[nodiscard]] std::span<const glm::dvec2> corners() const { return corners_; }
  /// Bounding rectangle of the polygon's pixels.
  [[nodiscard]] PixelRect pixels() const;

 private:
  std::vector<glm::dvec2> corners_;
  std::vector<glm::dvec2> clipped_;
  double reach_ = 0;  ///< maximum distance of the region's pixels from the picture's first pixel
};

}  // namespace csgsim::view
