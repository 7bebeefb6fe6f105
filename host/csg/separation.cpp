#include "host/csg/separation.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hw/isa/host_counts.h"

namespace csgsim::csg {

namespace {

constexpr int most_steps = 64;

/// Minimum distance of a support plane from the origin, relative to the hulls, for a trusted result.
constexpr double certainty = 1e-9;

/// Minimum scale of the hulls, relative to their coordinates. Rounding of about 1e-16 has to stay below `certainty`.
constexpr double coarsest = 1e-6;

}  // namespace

bool separated(std::span<const glm::dvec3> first, std::span<const glm::dvec3> second, const Counted& counted) {
  Hull one(first);
  Hull other(second);
  return separated(one, other, counted);
}

namespace {

/// Searches for planes that separate the hulls. For each, calls found(direction, a, b), until that returns false:
/// `direction` points from the second hull to the first; a and b are their points closest to the plane.
template <class Found>
void search(Hull& first, Hull& second, const Counted& counted, const Found& found) {
  if (first.points().empty() || second.points().empty()) return;
  const glm::dvec3 low = glm::min(first.low(), second.low());
  const glm::dvec3 high = glm::max(first.high(), second.high());
  // The scale equalizes the axes, but is limited so that rounding of coordinates remains negligible.
  const glm::dvec3 coarse = coarsest * glm::max(glm::abs(low), glm::abs(high));
  const glm::dvec3 size = glm::max(high - low, glm::max(coarse, glm::dvec3(1e-300)));
  const auto difference = [&](const glm::dvec3& a, const glm::dvec3& b) { return (a - b) / size; };

  glm::dvec3 nearest = difference(first.points().front(), second.points().front());
  for (int step = 0; step < most_steps; ++step) {
    // The point of the difference farthest back along `nearest`; directions transform inversely.
    const glm::dvec3 direction = nearest / size;
    counted.add(&isa::Preparation::supports, first.points().size() + second.points().size());
    const glm::dvec3 of_first = first.support(-direction);
    const glm::dvec3 of_second = second.support(direction);
    const glm::dvec3 farthest = difference(of_first, of_second);
    const double length = glm::length(nearest);
    if (!(length > certainty)) return;
    if (glm::dot(farthest, nearest) > certainty * length && !found(direction, of_first, of_second)) return;
    const glm::dvec3 edge = farthest - nearest;
    const double square = glm::dot(edge, edge);
    if (!(square > 0.0)) return;
    nearest += std::clamp(-glm::dot(nearest, edge) / square, 0.0, 1.0) * edge;
  }
}

/// Extent of a hull's box along a direction.
double extent_along(const Hull& hull, const glm::dvec3& direction) {
  return glm::dot(hull.high() - hull.low(), glm::abs(direction));
}

double narrowness(const Gap& gap) { return std::max(gap.far_first, gap.far_second) / gap.half; }

}  // namespace

bool separated(Hull& first, Hull& second, const Counted& counted) {
  bool are_separated = false;
  search(first, second, counted, [&](const auto&...) {
    are_separated = true;
    return false;
  });
  return are_separated;
}

std::optional<Gap> find_gap(Hull& first, Hull& second, const Counted& counted) {
  std::optional<Gap> widest;
  search(first, second, counted,
         [&](const glm::dvec3& direction, const glm::dvec3& of_first, const glm::dvec3& of_second) {
           counted.add(&isa::Preparation::supports, 2);
           const double half = glm::dot(direction, of_first - of_second) / 2;
           if (!(half > 0)) return true;
           const Gap gap{half, half + extent_along(first, direction), half + extent_along(second, direction)};
           if (!widest || narrowness(gap) < narrowness(*widest)) widest = gap;
           return !widest->is_wide();
         });
  return widest;
}

bool disjoint(const facet::Box& first, const facet::Box& second) {
  for (int axis = 0; axis < 3; ++axis) {
    if (first.low[axis] > second.high[axis] || second.low[axis] > first.high[axis]) return true;
  }
  return false;
}

bool disjoint(const view::View& view, std::uint32_t first, std::uint32_t second, const Pruning& pruning,
              const Counted& counted) {
  const view::Extent& first_extent = view.extents[first];
  const view::Extent& second_extent = view.extents[second];
  counted.add(&isa::Preparation::boxes, (pruning.picture ? 1U : 0U) + (pruning.space ? 1U : 0U));
  const bool in_picture = common(first_extent.pixels, second_extent.pixels).empty() ||
                          first_extent.z_low > second_extent.z_high || first_extent.z_high < second_extent.z_low;
  return (pruning.picture && in_picture) || (pruning.space && disjoint(first_extent.box, second_extent.box));
}

}  // namespace csgsim::csg
