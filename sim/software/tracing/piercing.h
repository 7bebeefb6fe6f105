// Intersection test of rays and convex polygons.
// Used by primary and secondary rays.
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>

#include "sim/software/cost/operations.h"
#include "sim/software/space/arithmetic.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

/// Decides whether a ray passes through a convex polygon, and in which direction. A ray through an edge hits exactly
/// one of the two facets that share it, as if displaced by an infinitesimal distance. The ray is sheared onto an axis
/// as in Woop and others 2013.
class Piercing {
 public:
  explicit Piercing(const SpaceRay& ray) : origin_(ray.origin) {
    const glm::dvec3 size = glm::abs(ray.direction);
    along_ = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    u_ = (along_ + 1) % 3;
    v_ = (along_ + 2) % 3;
    if (ray.direction[along_] < 0) std::swap(u_, v_);
    shear_u_ = ray.direction[u_] / ray.direction[along_];
    shear_v_ = ray.direction[v_] / ray.direction[along_];
  }

  /// 1 if the ray leaves through the polygon, -1 if it enters, 0 if it misses. Corners are counter-clockwise as seen
  /// from outside.
  template <class Count>
  int through(std::span<const glm::dvec3> corners, Count& count) const {
    int side = 0;
    Sheared from = sheared(corners.back());
    count_products(count, 2);
    for (const glm::dvec3& corner : corners) {
      const Sheared to = sheared(corner);
      const int one = side_of(from, to);
      count_products(count, 4);
      count(Operation::load_long, 3);
      count(Operation::add_long, 6);
      count(Operation::branch);
      if (one != 0 && side != 0 && one != side) return 0;
      if (one != 0) side = one;
      from = to;
    }
    return side;
  }

 private:
  struct Sheared {
    double u;
    double v;
  };

  [[nodiscard]] Sheared sheared(const glm::dvec3& corner) const {
    const glm::dvec3 to = corner - origin_;
    return {to[u_] - shear_u_ * to[along_], to[v_] - shear_v_ * to[along_]};
  }

  /// Side of an edge on which the ray passes. Reversing the edge reverses the side exactly, even with rounding.
  static int side_of(const Sheared& from, const Sheared& to) {
    const double area = from.u * to.v - from.v * to.u;
    const double first = area != 0 ? area : from.v - to.v;
    const double decides = first != 0 ? first : to.u - from.u;
    return decides > 0 ? 1 : (decides < 0 ? -1 : 0);
  }

  glm::dvec3 origin_;
  int along_ = 2;
  int u_ = 0;
  int v_ = 1;
  double shear_u_ = 0;
  double shear_v_ = 0;
};

/// Counts computing the distance along a ray to a polygon's plane and comparing it with the ends of the ray: two scalar
/// products and a division.
template <class Count>
void count_distance(Count& count) {
  count_products(count, 6);
  count_quotients(count, 1);
  count_comparisons(count, 2);
}

}  // namespace csgsim::software
