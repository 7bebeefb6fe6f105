#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::effects {

/// A convex polygon in the picture: columns and rows; may be a line or a point. Clipped in doubles, a little too large
/// rather than too small: what it is clipped to nothing by holds none of its points.
class Outline {
 public:
  Outline() = default;
  explicit Outline(const view::PixelRect& pixels);

  [[nodiscard]] bool empty() const { return corners_.empty(); }

  /// What is left where the line is not negative.
  [[nodiscard]] Outline clipped(const view::FixedLinear& line) const;

  /// Whether the line is negative everywhere.
  [[nodiscard]] bool is_beyond(const view::FixedLinear& line) const;

  /// Pixels that are in it, or near it.
  [[nodiscard]] view::PixelRect pixels() const;

 private:
  std::vector<glm::dvec2> corners_;
};

}  // namespace csgsim::effects
