#include "tests/oracle/pixel_oracle.h"

#include <algorithm>

#include "tests/oracle/tree_rules.h"

namespace csgsim::testing {

namespace {

/// Depths that a primitive fills along a ray: front <= z < back. Empty unless front < back.
struct Interval {
  std::int64_t front = 0;
  std::int64_t back = 0;
};

Interval interval(const facet::Convex& solid, const view::View& view, const view::PixelRect& rectangle, std::int64_t x,
                  std::int64_t y, std::int64_t farthest) {
  if (x < rectangle.x0 || x > rectangle.x1 || y < rectangle.y0 || y > rectangle.y1) return {};
  Interval in{0, farthest};
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    const view::ScreenPlane& plane = view.planes[halfspace.plane];
    const std::int64_t value = plane.linear.a * x + plane.linear.b * y + plane.linear.c;
    const bool same = plane.positive == halfspace.positive;
    if (plane.kind == view::PlaneKind::edge) {
      if ((value >= 0) != same) return {};
      continue;
    }
    const std::int64_t z = value >> view.sampling.fraction_bits;
    if (same) {
      in.front = std::max(in.front, z);
    } else {
      in.back = std::min(in.back, z);
    }
  }
  return in;
}

}  // namespace

std::vector<Seen> draw_by_rules(const model::Tree& tree, const facet::Scene& scene, const view::View& view) {
  const std::int64_t farthest = (std::int64_t{1} << view.sampling.z_bits) - 1;
  const Seen nothing{static_cast<std::uint32_t>(farthest), 0xffffffffU};
  std::vector<Seen> picture(static_cast<std::size_t>(view.sampling.width) * view.sampling.height, nothing);
  if (tree.root == model::no_index) return picture;
  const TreeRules rules(tree);
  std::vector<Interval> intervals(tree.primitives.size());
  std::vector<bool> held(tree.primitives.size());
  for (std::uint32_t y = 0; y < view.sampling.height; ++y) {
    for (std::uint32_t x = 0; x < view.sampling.width; ++x) {
      for (std::size_t p = 0; p < intervals.size(); ++p) {
        intervals[p] = interval(scene.solids[p], view, view.extents[p].pixels, x, y, farthest);
      }
      Seen& seen = picture[static_cast<std::size_t>(y) * view.sampling.width + x];
      for (std::uint32_t p = 0; p < intervals.size(); ++p) {
        if (intervals[p].front >= intervals[p].back) continue;
        const std::int64_t z = rules.taken_away(p) ? intervals[p].back : intervals[p].front;
        if (z >= static_cast<std::int64_t>(seen.depth)) continue;
        for (std::size_t q = 0; q < held.size(); ++q) held[q] = intervals[q].front <= z && z < intervals[q].back;
        if (rules.shows(p, held)) seen = {static_cast<std::uint32_t>(z), p};
      }
    }
  }
  return picture;
}

}  // namespace csgsim::testing
