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
  std::uint32_t plane = model::no_index;  ///< the canonical plane that contains the origin exactly, if any
};

/// The crossing of a ray from one side of a half-space to the other.
struct Crossing {
  double t = 0;
  std::uint32_t halfspace = model::no_index;  ///< index into facet::Convex::halfspaces; none at the start of the ray
  std::uint32_t plane = model::no_index;
  double lead = 0;  ///< distance in t from this half-space to the next of the same primitive
};

/// The part of a ray inside a primitive: in.t <= t < out.t. Empty unless in.t < out.t.
struct Span {
  Crossing in;
  Crossing out;

  [[nodiscard]] bool empty() const { return in.t >= out.t; }
};

/// A point of the model's surface that faces the origin of a ray.
struct SurfacePoint {
  double t = 0;
  std::uint32_t primitive = model::no_index;
  std::uint32_t halfspace = model::no_index;  ///< none for a cut by the near plane
  std::uint32_t plane = model::no_index;
  bool is_clear = true;  ///< whether all decisions up to this point exceed the gap
};

/// The surface points of a ray, nearest first.
struct Surfaces {
  std::vector<SurfacePoint> points;
  bool is_clear = true;  ///< whether the absence of other points exceeds the gap
};

/// The part of a ray to search. Surfaces on the canonical plane of its origin are omitted.
struct Stretch {
  double from = 0;
  std::uint32_t plane = model::no_index;
};

/// Whether the model intersects a ray, and whether that decision exceeds the gap.
struct Occlusion {
  bool is_blocked = false;
  bool is_clear = true;
};

/// A tree of convex primitives along a ray, in double precision. Coincident faces are one canonical plane
/// (docs/numbers.md), so a ray meets them at exactly the same t. Decisions that differ by less than `gap`, in t, are
/// uncertain because of rounding: nearby crossings of different planes, and primitives hit or missed narrowly.
class RayModel {
 public:
  /// Keeps references to both.
  RayModel(const model::Tree& tree, const facet::Geometry& scene);

  /// All surface points beyond `from`: the `in` of a primitive, or the `out` of a subtracted one, if every operand that
  /// an intersection (in positive form) combines with it contains the point. Of several at one t, only the first in
  /// tree order. Primitives that extend through `from` are cut open there, unless that is on a plane.
  [[nodiscard]] Surfaces surfaces(const Ray& ray, const Stretch& stretch, double gap) const;

  /// Whether the open interval 0 < t < length meets the model's interior.
  [[nodiscard]] Occlusion occlusion(const Ray& ray, double length, double gap) const;

  /// The unit normal out of the model: for a subtracted primitive, into the primitive.
  [[nodiscard]] glm::dvec3 normal(std::uint32_t primitive, std::uint32_t halfspace) const;

  [[nodiscard]] bool is_subtracted(std::uint32_t primitive) const { return rules_.is_subtracted(primitive); }

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
