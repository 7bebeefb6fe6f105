#include "sim/software/space/facet_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>

#include "sim/software/space/arithmetic.h"

namespace csgsim::software {

namespace {

facet::Box grown(const facet::Box& box, double by) { return {box.low - by, box.high + by}; }

glm::dvec3 normal_of(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum{0};
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  const double length = glm::length(sum);
  return length > 0 ? sum / length : glm::dvec3{0};
}

double compute_default_reach(const Facets& facets) { return default_reach * facet::box_of(facets.corners).diagonal(); }

/// A box as centre and half extents, and the minimum length of an edge whose direction is used.
struct Block {
  glm::dvec3 middle;
  glm::dvec3 half;
  double min_edge;
};

bool is_apart_along(const glm::dvec3& axis, std::span<const glm::dvec3> corners, const Block& block) {
  const double reach = glm::dot(glm::abs(axis), block.half);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const glm::dvec3& corner : corners) {
    const double at = glm::dot(axis, corner - block.middle);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return low > reach || high < -reach;
}

/// Whether a line along the axis through an edge separates the polygon from the block. A polygon seen edge-on along the
/// axis has no sides.
bool is_apart_across(int axis, const glm::dvec3& from, const glm::dvec3& to, double normal, const Block& block) {
  constexpr double edge_on = 1e-6;
  if (std::abs(normal) < edge_on) return false;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  // Outward direction, for corners that are counter-clockwise if the normal points along the axis.
  double out_u = to[v] - from[v];
  double out_v = from[u] - to[u];
  if (normal < 0) {
    out_u = -out_u;
    out_v = -out_v;
  }
  const double length = std::abs(out_u) + std::abs(out_v);
  if (length < block.min_edge) return false;
  const double nearest = out_u * (block.middle[u] - from[u]) + out_v * (block.middle[v] - from[v]) -
                         std::abs(out_u) * block.half[u] - std::abs(out_v) * block.half[v];
  return nearest > 0;
}

}  // namespace

FacetShapes::FacetShapes(const Facets& facets) : FacetShapes(facets, compute_default_reach(facets)) {}

FacetShapes::FacetShapes(const Facets& facets, double reach)
    : facets_(facets), reach_(reach), boxes_(facets.facets.size()), normals_(facets.facets.size()) {
  for (std::uint32_t i = 0; i < facets.facets.size(); ++i) {
    const std::span<const glm::dvec3> corners = facets.corners_of(i);
    if (corners.empty()) {
      unplaced_.push_back(i);
      continue;
    }
    placed_.push_back(i);
    boxes_[i] = grown(facet::box_of(corners), reach);
    normals_[i] = normal_of(corners);
    box_ = facet::hull(box_, grown(boxes_[i], reach));
  }
}

bool FacetShapes::touches(std::uint32_t facet, const facet::Box& box, Counting& count) const {
  constexpr double shortest = 1e-6;
  constexpr std::uint64_t sides = 6;
  count(Operation::call);
  count(Operation::come_back);
  count_comparisons(count, sides);
  if (facet::common(box, boxes_[facet]).empty()) return false;
  const std::span<const glm::dvec3> corners = facets_.corners_of(facet);
  const Block block{box.centre(), (box.high - box.low) / 2.0 + reach_, shortest * box_.diagonal()};
  const glm::dvec3& normal = normals_[facet];
  if (corners.size() == 2) {
    const glm::dvec3 along = corners[1] - corners[0];
    count_products(count, 2 * sides);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 unit{0};
      unit[axis] = 1;
      if (is_apart_along(glm::cross(unit, along), corners, block)) return false;
    }
    return true;
  }
  if (corners.size() < 3) return true;
  count_products(count, 3 * corners.size() + 3);
  count_comparisons(count, 2);
  if (is_apart_along(normal, corners, block)) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& next = corners[(i + 1) % corners.size()];
    for (int axis = 0; axis < 3; ++axis) {
      count_products(count, 4);
      count_comparisons(count, 1);
      if (is_apart_across(axis, corners[i], next, normal[axis], block)) return false;
    }
  }
  return true;
}

}  // namespace csgsim::software
