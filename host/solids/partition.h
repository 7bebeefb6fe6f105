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

/// A corner of a part of a face, and whether the edge from it to the next corner is reflex: the solid has more than 180
/// degrees there.
struct Corner {
  std::uint32_t point = 0;
  bool reflex = false;
};

/// A convex part of a face.
struct Fragment {
  facet::Halfspace halfspace;  ///< the solid is on this side of it
  std::uint32_t begin = 0;     ///< of its corners in Soup::corners
  std::uint32_t end = 0;
};

/// The surface of a solid in parts that need not be joined.
struct Soup {
  std::vector<glm::dvec3> points;  ///< relative to PlaneTable::centre()
  std::vector<Corner> corners;
  std::vector<Fragment> fragments;
};

/// Calls visit(a, b, c) for the triangles that fan out from the first corner of a fragment.
template <class Visit>
void for_triangles(const Soup& soup, const Fragment& fragment, const Visit& visit) {
  const auto point = [&](std::uint32_t i) -> const glm::dvec3& { return soup.points[soup.corners[i].point]; };
  for (std::uint32_t i = fragment.begin + 1; i + 1 < fragment.end; ++i)
    visit(point(fragment.begin), point(i), point(i + 1));
}

/// A plane across an axis that many reflex edges are in, as between the slices of a twist: faces end there, so that it
/// cuts few of them.
struct Level {
  int axis = 0;
  double place = 0;  ///< relative to PlaneTable::centre()
  facet::Halfspace halfspace;
};

/// Faces leave a hole in the solid's surface; or planes that stand for several faces do.
class HoleError : public InputError {
 public:
  using InputError::InputError;
};

/// The solid within a surface, as convex polytopes that do not overlap. Space is divided by planes of the surface's
/// faces, or by levels (in order of axis and place), until what of the surface is left in a cell is part of a convex
/// solid's: each fragment is behind the planes of all. Points nearer to a plane than `near`, in model units, are on it.
/// The cell has to hold the surface, at a distance. Throws InputError if there are more pieces or fragments than the
/// limits allow, a HoleError if the surface is open, and a WorkError past the limit on work.
std::vector<convex::Polytope> partition(Soup soup, convex::Polytope cell, std::span<const Level> levels,
                                        const facet::PlaneTable& planes, double near, const Limits& limits);

}  // namespace csgsim::solids
