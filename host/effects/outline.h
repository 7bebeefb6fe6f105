// Convex polygons in the picture, clipped conservatively.
// Used by the shadow effect.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::effects {

/// A convex polygon in the picture, in columns and rows; may be a line or a point. Clipping uses doubles and leaves too
/// much rather than too little: if nothing is left, no point of the polygon satisfies the condition.
class Outline {
 public:
  Outline() = default;
  explicit Outline(const view::PixelRect& pixels);

  [[nodiscard]] bool empty() const { return corners_.empty(); }

  /// The part of the polygon where the line is not negative.
  [[nodiscard]] Outline clipped(const view::FixedLinear& line) const;

  /// Clips in place; `spare` is a scratch outline, whose memory is reused. Returns false if nothing is left.
  bool clip(const view::FixedLinear& line, Outline& spare);

  /// Position of an outline relative to a line.
  enum class Position : std::uint8_t {
    beyond,  ///< the line is negative in the whole outline
    across,
    within,  ///< the line is certainly at least `least` in the whole outline
  };
  [[nodiscard]] Position position(const view::FixedLinear& line, double minimum) const;

  /// Bounding rectangle of its pixels, with a margin.
  [[nodiscard]] view::PixelRect pixels() const;

  [[nodiscard]] const std::vector<glm::dvec2>& corners() const { return corners_; }

 private:
  std::vector<glm::dvec2> corners_;
};

}  // namespace csgsim::effects
