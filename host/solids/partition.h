// Division of a solid into convex polytopes by planes of its faces.
// Used throughout host/solids.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"
#include "host/solids/limits.h"
#include "hw/base/error.h"

namespace csgsim::solids {

/// A corner of a fragment, and whether the edge to the next corner is reflex: the solid's dihedral angle there exceeds
/// 180 degrees.
struct Corner {
  std::uint32_t point = 0;
  bool reflex = false;
};

/// A convex part of a face.
struct Fragment {
  facet::Halfspace halfspace;  ///< the half-space on the solid's side of the plane
  std::uint32_t begin = 0;     ///< first corner, an index into Soup::corners
  std::uint32_t end = 0;
};

/// The surface of a solid as fragments that need not be connected.
struct Soup {
  std::vector<glm::dvec3> points;  ///< relative to PlaneTable::centre()
  std::vector<Corner> corners;
  std::vector<Fragment> fragments;
};

/// Calls visit(a, b, c) for the triangles that fan out from the first corner of a fragment.
template <class Visit>
void for_each_triangle(const Soup& soup, const Fragment& fragment, const Visit& visit) {
  const auto point = [&](std::uint32_t i) -> const glm::dvec3& { return soup.points[soup.corners[i].point]; };
  for (std::uint32_t i = fragment.begin + 1; i + 1 < fragment.end; ++i)
    visit(point(fragment.begin), point(i), point(i + 1));
}

/// A plane across an axis that contains many reflex edges, such as the planes between the slices of a twist. Faces end
/// at such a plane, so it cuts few of them.
struct Level {
  int axis = 0;
  double place = 0;  ///< relative to PlaneTable::centre()
  facet::Halfspace halfspace;
};

/// Thrown if the surface has a hole, either in its faces or in the planes that replace several faces.
class HoleError : public InputError {
 public:
  using InputError::InputError;
};

/// The solid inside a surface, as convex polytopes that do not overlap. Space is divided by planes of the surface's
/// faces, or by levels (sorted by axis and place), until the surface in each cell is part of a convex solid: each
/// fragment is behind the planes of all others. Points closer to a plane than `near`, in model units, are treated as on
/// it. The cell must contain the surface with a margin. Throws InputError if there are more pieces or fragments than
/// the limits allow, HoleError if the surface is open, and WorkError if the work limit is exceeded.
std::vector<convex::Polytope> partition(Soup soup, convex::Polytope cell, std::span<const Level> levels,
                                        const facet::PlaneTable& planes, double near, const Limits& limits);

}  // namespace csgsim::solids
