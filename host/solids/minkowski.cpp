#include "host/solids/minkowski.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>

#include "host/facet/geometry.h"
#include "host/solids/hull.h"
#include "host/solids/limits.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

std::size_t count_corners(const Pieces& pieces) {
  std::size_t count = 0;
  for (const model::Polyhedron& piece : pieces) count += piece.points.size();
  return count;
}

/// Whether all points of `other` are behind all planes of `piece`, apart from rounding.
bool contains(const model::Polyhedron& piece, const model::Polyhedron& other, double near) {
  return std::all_of(piece.planes.begin(), piece.planes.end(), [&](const glm::dvec4& plane) {
    return std::all_of(other.points.begin(), other.points.end(),
                       [&](const glm::dvec3& point) { return glm::dot(glm::dvec3(plane), point) + plane.w <= near; });
  });
}

/// Removes pieces that are inside other pieces; of equal pieces the last one stays.
Pieces without_covered(Pieces pieces, const Work& work) {
  std::vector<facet::Box> boxes;
  facet::Box whole;
  for (const model::Polyhedron& piece : pieces) {
    boxes.push_back(facet::box_of(piece.points));
    whole = facet::hull(whole, boxes.back());
  }
  const double near = double_precision_tolerance * whole.diagonal();
  const auto box_holds = [&](const facet::Box& outer, const facet::Box& inner) {
    return glm::all(glm::lessThanEqual(outer.low - near, inner.low)) &&
           glm::all(glm::lessThanEqual(inner.high, outer.high + near));
  };
  std::vector<bool> covered(pieces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    work.charge(4 * pieces.size(), "removing nested pieces of a Minkowski sum");
    for (std::size_t other = 0; other < pieces.size() && !covered[i]; ++other) {
      covered[i] = other != i && !covered[other] && box_holds(boxes[other], boxes[i]) &&
                   contains(pieces[other], pieces[i], near);
    }
  }
  Pieces kept;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!covered[i]) kept.push_back(std::move(pieces[i]));
  }
  return kept;
}

Pieces sum(const Pieces& first, const Pieces& second, const Work& work) {
  if (count_corners(first) > max_sums / std::max<std::size_t>(count_corners(second), 1)) {
    throw InputError("the Minkowski sum needs more than " + std::to_string(max_sums) +
                     " sums of corners; use fewer facets ($fn)");
  }
  Pieces made;
  std::vector<glm::dvec3> sums;
  for (const model::Polyhedron& one : first) {
    for (const model::Polyhedron& other : second) {
      sums.clear();
      for (const glm::dvec3& a : one.points) {
        for (const glm::dvec3& b : other.points) sums.push_back(a + b);
      }
      if (std::optional<model::Polyhedron> piece = hull_piece(sums, work)) made.push_back(std::move(*piece));
    }
  }
  return without_covered(std::move(made), work);
}

}  // namespace

Pieces minkowski(std::span<const Pieces> solids, const Work& work) {
  Pieces total;
  for (const Pieces& solid : solids) {
    if (!solid.empty()) total = total.empty() ? solid : sum(total, solid, work);
  }
  return total;
}

}  // namespace csgsim::solids
