#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
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

  /// How it lies to a line.
  enum class Lie : std::uint8_t {
    beyond,  ///< the line is negative everywhere
    across,
    within,  ///< the line is surely `least` at least everywhere
  };
  [[nodiscard]] Lie lie(const view::FixedLinear& line, double least) const;

  /// Pixels that are in it, or near it.
  [[nodiscard]] view::PixelRect pixels() const;

  [[nodiscard]] const std::vector<glm::dvec2>& corners() const { return corners_; }

 private:
  std::vector<glm::dvec2> corners_;
};

}  // namespace csgsim::effects
