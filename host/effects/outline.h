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

  /// As clipped(), in place; `spare` is room for another outline, which is kept. False if nothing is left.
  bool clip(const view::FixedLinear& line, Outline& spare);

  /// Whether the line is negative everywhere.
  [[nodiscard]] bool is_beyond(const view::FixedLinear& line) const;

  /// Pixels that are in it, or near it.
  [[nodiscard]] view::PixelRect pixels() const;

  [[nodiscard]] const std::vector<glm::dvec2>& corners() const { return corners_; }

 private:
  std::vector<glm::dvec2> corners_;
};

/// A box around an outline, which tells faster.
class OutlineBox {
 public:
  explicit OutlineBox(const Outline& outline);

  /// Whether the line is negative, by more than rounding takes, everywhere in the box: then whatever the outline is
  /// clipped to is beyond it too. False may be so all the same.
  [[nodiscard]] bool is_beyond(const view::FixedLinear& line) const;

 private:
  glm::dvec2 low_{0};
  glm::dvec2 high_{0};
};

}  // namespace csgsim::effects
