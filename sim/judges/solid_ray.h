#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::judges {

using LongVector = glm::vec<3, long double>;
using LongMatrix = glm::mat<4, 4, long double>;

/// A line: origin + t direction.
struct Line {
  LongVector origin;
  LongVector direction;
};

/// Parameters low <= t < high of a line. Empty unless low < high.
struct Interval {
  long double low;
  long double high;

  [[nodiscard]] bool empty() const { return !(low < high); }
};

/// A primitive as it is meant, not faceted.
class TrueSolid {
 public:
  explicit TrueSolid(const model::Primitive& primitive);

  /// The part of a line in model space that is in the solid.
  [[nodiscard]] Interval on(const Line& line) const;

  /// Eight points in model space whose convex hull holds the solid.
  [[nodiscard]] std::vector<LongVector> corners() const;

 private:
  /// normal . p + offset <= 0.
  struct Side {
    LongVector normal;
    long double offset;
  };

  // The part of a line in object space that is in a shape: one for each of model::Shape.
  [[nodiscard]] Interval within(const model::Cube& shape, const Line& line) const;
  [[nodiscard]] static Interval within(const model::Sphere& shape, const Line& line);
  [[nodiscard]] static Interval within(const model::Cylinder& shape, const Line& line);
  [[nodiscard]] Interval within(const model::Polyhedron& shape, const Line& line) const;

  const model::Primitive& primitive_;
  LongMatrix to_model_;
  LongMatrix to_object_;
  LongVector low_;  ///< of a box around the solid in object space
  LongVector high_;
  std::vector<Side> sides_;  ///< of a polyhedron
};

}  // namespace csgsim::judges
