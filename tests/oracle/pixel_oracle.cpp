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

/// The integer square root, rounded down.
std::int64_t root_of(std::int64_t square) {
  std::int64_t root = 0;
  for (std::int64_t bit = std::int64_t{1} << 30; bit > 0; bit /= 2) {
    if ((root + bit) * (root + bit) <= square) root += bit;
  }
  return root;
}

/// The part of an interval inside a quadric.
Interval within(Interval in, const view::ScreenQuadric& quadric, view::QuadricRole role, unsigned fraction_bits,
                std::int64_t x, std::int64_t y) {
  const view::FixedQuadratic& f = quadric.discriminant;
  const std::int64_t value = f.xx * x * x + f.xy * x * y + f.yy * y * y + f.linear.a * x + f.linear.b * y + f.linear.c;
  if (role == view::QuadricRole::edge) return value >= 0 ? in : Interval{};
  const std::int64_t d = value >> quadric.discriminant_shift;
  if (d < 0) return role == view::QuadricRole::until ? in : Interval{};
  const std::int64_t middle = (quadric.middle.a * x + quadric.middle.b * y + quadric.middle.c) >> fraction_bits;
  const std::int64_t one = std::int64_t{1} << quadric.unit;
  const std::int64_t root = root_of(d);
  const std::int64_t near = middle - root * one;
  const std::int64_t far = middle + (root + 1) * one;
  switch (role) {
    case view::QuadricRole::between: return {std::max(in.front, near), std::min(in.back, far)};
    case view::QuadricRole::until: return {in.front, std::min(in.back, near)};
    case view::QuadricRole::from: return {std::max(in.front, far), in.back};
    case view::QuadricRole::edge: break;
  }
  return in;
}

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
  for (const facet::QuadricSide& side : solid.quadrics) {
    const view::ScreenQuadric& quadric = view.quadrics[side.quadric];
    in = within(in, quadric, view::role_of(quadric, side), view.sampling.fraction_bits, x, y);
  }
  return in;
}

}  // namespace

std::vector<Seen> draw_by_rules(const model::Tree& tree, const facet::Geometry& scene, const view::View& view) {
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
        const std::int64_t z = rules.is_subtracted(p) ? intervals[p].back : intervals[p].front;
        if (z >= static_cast<std::int64_t>(seen.depth)) continue;
        for (std::size_t q = 0; q < held.size(); ++q) held[q] = intervals[q].front <= z && z < intervals[q].back;
        if (rules.shows(p, held)) seen = {static_cast<std::uint32_t>(z), p};
      }
    }
  }
  return picture;
}

}  // namespace csgsim::testing
