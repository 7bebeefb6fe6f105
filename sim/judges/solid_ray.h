// Intersections of rays with true, unfaceted primitives.
// Used by the analytic truth.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::judges {

using LongVector = glm::vec<3, long double>;
using LongMatrix = glm::mat<4, 4, long double>;

/// The line origin + t direction.
struct Line {
  LongVector origin;
  LongVector direction;
};

/// The parameters low <= t < high of a line. Empty unless low < high.
struct Interval {
  long double low;
  long double high;

  [[nodiscard]] bool empty() const { return !(low < high); }
};

/// A primitive as the model intends it, without facets.
class TrueSolid {
 public:
  explicit TrueSolid(const model::Primitive& primitive);

  /// The part of a model-space line that is inside the solid.
  [[nodiscard]] Interval on(const Line& line) const;

  /// Eight points in model space whose convex hull contains the solid.
  [[nodiscard]] std::vector<LongVector> corners() const;

 private:
  /// The half-space normal . p + offset <= 0.
  struct Side {
    LongVector normal;
    long double offset;
  };

  // The part of an object-space line that is inside a shape, for each alternative of model::Shape.
  [[nodiscard]] Interval within(const model::Cube& shape, const Line& line) const;
  [[nodiscard]] static Interval within(const model::Sphere& shape, const Line& line);
  [[nodiscard]] static Interval within(const model::Cylinder& shape, const Line& line);
  [[nodiscard]] Interval within(const model::Polyhedron& shape, const Line& line) const;

  const model::Primitive& primitive_;
  LongMatrix to_model_;
  LongMatrix to_object_;
  LongVector low_;  ///< corners of a bounding box in object space
  LongVector high_;
  std::vector<Side> sides_;  ///< sides of a polyhedron
};

}  // namespace csgsim::judges
