#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "tests/oracle/tree_rules.h"

namespace csgsim::testing {

/// A line in model space: origin + t * direction.
struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;
  std::uint32_t plane = model::no_index;  ///< the canonical plane that the origin is on, exactly, if it is on one
};

/// Where a ray passes from one side of a half-space to the other.
struct Crossing {
  double t = 0;
  std::uint32_t halfspace = model::no_index;  ///< index into facet::Convex::halfspaces; none where the ray begins
  std::uint32_t plane = model::no_index;
  double lead = 0;  ///< t between this half-space and the next of the same primitive
};

/// What a primitive fills of a ray: in.t <= t < out.t. Empty unless in.t < out.t.
struct Span {
  Crossing in;
  Crossing out;

  [[nodiscard]] bool empty() const { return in.t >= out.t; }
};

/// A point of the model's surface that faces the origin of a ray.
struct SurfacePoint {
  double t = 0;
  std::uint32_t primitive = model::no_index;
  std::uint32_t halfspace = model::no_index;  ///< none where the near plane cuts the primitive open
  std::uint32_t plane = model::no_index;
  bool is_clear = true;  ///< nothing up to here is decided by less than the gap
};

/// The surface points of a ray, nearest first.
struct Surfaces {
  std::vector<SurfacePoint> points;
  bool is_clear = true;  ///< it is not decided by less than the gap that there are no others
};

/// Where a ray is looked along. Surfaces on the canonical plane that it begins at are left out.
struct Stretch {
  double from = 0;
  std::uint32_t plane = model::no_index;
};

/// Whether something of the model is on a ray, and whether that is decided by more than the gap.
struct Occlusion {
  bool is_blocked = false;
  bool is_clear = true;
};

/// A tree of convex primitives along a ray, in double precision. Coincident faces are one canonical plane
/// (docs/numbers.md), so that they are met at exactly the same t. `gap`, in t, is what separates decisions that
/// rounding might take otherwise: crossings of different planes that are closer than that, and primitives that are hit
/// or missed by less.
class RayModel {
 public:
  /// Keeps references to both.
  RayModel(const model::Tree& tree, const facet::Geometry& scene);

  /// All surface points beyond `from`: the `in` of a primitive, or the `out` of one that is taken away,
  /// where every operand that an intersection (in positive form) combines it with holds the point. Of those at one t
  /// only the first in tree order. What reaches through `from` is cut open there, unless that is on a plane.
  [[nodiscard]] Surfaces surfaces(const Ray& ray, const Stretch& stretch, double gap) const;

  /// Whether the open stretch 0 < t < length meets the model's interior.
  [[nodiscard]] Occlusion occlusion(const Ray& ray, double length, double gap) const;

  /// Out of the model, of length 1: for a primitive that is taken away, into the primitive.
  [[nodiscard]] glm::dvec3 normal(std::uint32_t primitive, std::uint32_t halfspace) const;

  [[nodiscard]] bool taken_away(std::uint32_t primitive) const { return rules_.taken_away(primitive); }

 private:
  struct Ball {
    glm::dvec3 centre;
    double radius;
  };
  [[nodiscard]] Span span(std::uint32_t primitive, const Ray& ray) const;
  [[nodiscard]] std::vector<Span> spans(const Ray& ray) const;
  [[nodiscard]] bool holds(const std::vector<Span>& spans, double t) const;

  const facet::Geometry& scene_;
  TreeRules rules_;
  std::vector<Ball> balls_;
};

}  // namespace csgsim::testing
