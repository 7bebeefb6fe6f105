#include "host/solids/covered.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace csgsim::solids {

namespace {

/// Slivers along a side that may be lost.
constexpr double slivers = 8;

/// Of a convex polygon, of which `corner(i)` is a corner.
template <class Corner>
double area_of(std::size_t corners, const Corner& corner) {
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < corners; ++i) sum += glm::cross(corner(i) - corner(0), corner(i + 1) - corner(0));
  return glm::length(sum) / 2;
}

}  // namespace

bool is_covered(const convex::Polytope& piece, std::span<const facet::Halfspace> walls, const Soup& surface,
                double near) {
  double missing = 0;
  for (const convex::Face& face : piece.faces) {
    if (std::ranges::find(walls, face.halfspace) != walls.end()) continue;
    const auto corner = [&](std::size_t i) { return piece.vertices[face.corners[i % face.corners.size()]]; };
    double around = 0;
    for (std::size_t i = 0; i < face.corners.size(); ++i) around += glm::distance(corner(i), corner(i + 1));
    missing += area_of(face.corners.size(), corner) - slivers * near * around;
  }
  for (const Fragment& fragment : surface.fragments) {
    const auto corner = [&](std::size_t i) { return surface.points[surface.corners[fragment.begin + i].point]; };
    missing -= area_of(fragment.end - fragment.begin, corner);
  }
  return missing <= 0;
}

}  // namespace csgsim::solids
