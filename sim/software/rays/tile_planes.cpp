#include "sim/software/rays/tile_planes.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "host/csg/locate.h"
#include "hw/base/error.h"

namespace csgsim::software {

namespace {

using Linear = view::FixedLinear;
using Corners = std::array<std::int64_t, 4>;

/// The values at a tile's corners, negated where the least counts.
Corners at_corners(const Linear& linear, const view::PixelRect& tile, std::int64_t sign) {
  const auto at = [&](std::int32_t x, std::int32_t y) { return sign * (linear.a * x + linear.b * y + linear.c); };
  return {at(tile.x0, tile.y0), at(tile.x1, tile.y0), at(tile.x0, tile.y1), at(tile.x1, tile.y1)};
}

bool is_nowhere_above(const Corners& one, const Corners& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (one[i] > other[i]) return false;
  }
  return true;
}

/// Keeps the planes that are not nowhere above one of those that are greatest at a corner.
void keep_bounding(std::span<const Linear> all, const view::PixelRect& tile, std::int64_t sign,
                   std::vector<Linear>& kept) {
  kept.assign(all.begin(), all.end());
  if (all.size() < 2) return;
  thread_local std::vector<Corners> values;
  values.clear();
  for (const Linear& one : all) values.push_back(at_corners(one, tile, sign));
  std::array<std::size_t, 4> greatest{};
  for (std::size_t i = 1; i < values.size(); ++i) {
    for (std::size_t corner = 0; corner < greatest.size(); ++corner) {
      if (values[i][corner] > values[greatest[corner]][corner]) greatest[corner] = i;
    }
  }
  kept.clear();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_hidden = std::ranges::any_of(greatest, [&](std::size_t by) {
      if (by == i || !is_nowhere_above(values[i], values[by])) return false;
      return i > by || !is_nowhere_above(values[by], values[i]);  // of two alike the first stays
    });
    if (!is_hidden) kept.push_back(all[i]);
  }
}

[[noreturn]] void refuse(const model::Tree& tree, std::uint32_t primitive) {
  throw InputError(
      model::place_of(tree, primitive) +
      ": a face of this primitive is too large for the picture: its coefficients do not fit the numbers of "
      "machines; move the camera back or the picture's centre onto it, give up --z-bits or "
      "--fraction-bits, or split the primitive");
}

}  // namespace

TilePlanes planes_of(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                     std::uint32_t primitive) {
  TilePlanes planes;
  const csg::Block anywhere{view.extents[primitive].pixels, 0, (std::int64_t{1} << view.sampling.z_bits) - 1};
  if (anywhere.pixels.empty()) return planes;
  for (const facet::Halfspace halfspace : geometry.solids[primitive].halfspaces) {
    const view::ScreenPlane& plane = view.planes[halfspace.plane];
    if (!plane.representable) {
      const csg::Known known = csg::locate(view, halfspace, anywhere);
      if (known == csg::Known::depends) refuse(tree, primitive);
      planes.nowhere = planes.nowhere || known == csg::Known::out;
      continue;
    }
    switch (view::side_of(plane, halfspace)) {
      case view::Side::front: planes.fronts.push_back(plane.linear); break;
      case view::Side::back: planes.backs.push_back(plane.linear); break;
      case view::Side::edge_positive: planes.edges.push_back({plane.linear, true}); break;
      case view::Side::edge_negative: planes.edges.push_back({plane.linear, false}); break;
    }
  }
  return planes;
}

std::uint64_t leave_out_hidden(const TilePlanes& all, const view::PixelRect& tile, TilePlanes& left) {
  keep_bounding(all.fronts, tile, 1, left.fronts);
  keep_bounding(all.backs, tile, -1, left.backs);
  return all.fronts.size() + all.backs.size();
}

}  // namespace csgsim::software
