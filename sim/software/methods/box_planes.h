// Boxes of pixels and depths, and the planes that bound primitives in them.
// Used by interval arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/methods/method.h"
#include "sim/software/rays/caster.h"
#include "sim/software/rays/longs.h"
#include "sim/software/rays/quadric_depths.h"
#include "sim/software/rays/tile_planes.h"

namespace csgsim::software {

/// A box of pixels and depths z0 <= z < z1.
struct Box {
  view::PixelRect pixels;
  std::uint32_t z0 = 0;
  std::uint32_t z1 = 0;
};

/// A primitive with the planes that bound it somewhere in a box.
struct BoxPrimitive {
  std::uint32_t primitive = 0;
  TilePlanes planes;
};

/// The front or rear half of a box in depth, divided into four parts; parts without pixels are omitted.
inline std::vector<Box> divide_half_box(const Box& box, bool is_far) {
  const std::uint32_t middle = box.z0 + (box.z1 - box.z0) / 2;
  const std::uint32_t z0 = is_far ? middle : box.z0;
  const std::uint32_t z1 = is_far ? box.z1 : middle;
  const std::int32_t x = box.pixels.x0 + (box.pixels.x1 - box.pixels.x0) / 2;
  const std::int32_t y = box.pixels.y0 + (box.pixels.y1 - box.pixels.y0) / 2;
  std::vector<Box> parts;
  if (z0 == z1) return parts;
  for (const view::PixelRect& pixels :
       {view::PixelRect{box.pixels.x0, box.pixels.y0, x, y}, view::PixelRect{x + 1, box.pixels.y0, box.pixels.x1, y},
        view::PixelRect{box.pixels.x0, y + 1, x, box.pixels.y1},
        view::PixelRect{x + 1, y + 1, box.pixels.x1, box.pixels.y1}}) {
    if (!pixels.empty()) parts.push_back({pixels, z0, z1});
  }
  return parts;
}

/// Bounds of a plane over pixels, from two corners selected by the signs of its slopes; values occupy `longs` longs.
template <class Count>
view::Range bounds(const view::FixedLinear& plane, const view::PixelRect& pixels, std::uint64_t longs, Count& count) {
  count.visit();
  count(Operation::load_long, 3 * longs);
  count(Operation::multiply, 4 * longs);
  count(Operation::add_long, 4 * longs);
  count(Operation::compare_long, 2 * longs);
  count(Operation::branch, 2);
  return view::range_over(plane, pixels);
}

/// Appends to `kept` the planes that may be maximal (or minimal, if not `greatest`) somewhere over the pixels; returns
/// bounds of that maximum (or minimum).
template <class Count>
view::Range keep_bounding(std::span<const view::FixedLinear> planes, const view::PixelRect& pixels, bool is_maximum,
                          std::uint64_t longs, std::vector<view::FixedLinear>& kept, Count& count) {
  constexpr view::Range none{std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min()};
  view::Range extreme = is_maximum ? none : view::Range{-(none.low + 1), -(none.low + 1)};
  std::vector<view::Range> ranges;
  ranges.reserve(planes.size());
  for (const view::FixedLinear& plane : planes) {
    const view::Range range = ranges.emplace_back(bounds(plane, pixels, longs, count));
    if (is_maximum) {
      extreme = {std::max(extreme.low, range.low), std::max(extreme.high, range.high)};
    } else {
      extreme = {std::min(extreme.low, range.low), std::min(extreme.high, range.high)};
    }
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const bool never = is_maximum ? ranges[i].high < extreme.low : ranges[i].low > extreme.high;
    if (!never) kept.push_back(planes[i]);
  }
  count(Operation::compare_long, 3 * longs * planes.size());
  count(Operation::branch_taken, 3 * planes.size());
  return extreme;
}

/// Classifies a primitive in a box as inside, outside or unknown; `narrowed` receives the planes that may bound
/// it in the box.
template <class Count>
Known classify_in_box(const Subject& subject, const Box& box, const BoxPrimitive& bounded, BoxPrimitive& narrowed,
                      Count& count) {
  const view::PixelRect pixels = view::common(box.pixels, subject.view.extents[bounded.primitive].pixels);
  if (pixels.empty()) return Known::out;
  const std::uint64_t longs = longs_of(subject.view.sampling);
  for (const TilePlanes::Edge& edge : bounded.planes.edges) {
    const view::Range range = bounds(edge.linear, pixels, longs, count);
    const bool is_in = edge.positive ? range.low >= 0 : range.high < 0;
    const bool is_out = edge.positive ? range.high < 0 : range.low >= 0;
    if (is_out) return Known::out;
    if (!is_in) narrowed.planes.edges.push_back(edge);
  }
  const unsigned shift = subject.view.sampling.fraction_bits;
  view::Range front = keep_bounding(bounded.planes.fronts, pixels, true, longs, narrowed.planes.fronts, count);
  view::Range back = keep_bounding(bounded.planes.backs, pixels, false, longs, narrowed.planes.backs, count);
  front = {front.low >> shift, front.high >> shift};
  back = {back.low >> shift, back.high >> shift};
  count(Operation::compare_long, 5);
  count(Operation::branch, 5);
  if (front.low >= box.z1 || back.high <= box.z0 || front.low >= back.high) return Known::out;
  const bool is_whole = pixels == box.pixels && narrowed.planes.edges.empty() &&
                        subject.geometry.solids[bounded.primitive].quadrics.empty();
  return is_whole && front.high <= box.z0 && back.low >= box.z1 ? Known::in : Known::nothing;
}

/// The intersection of a ray and a primitive, computed from the planes that may bound it in the box; empty
/// if there is none.
template <class Count>
std::optional<Interval> interval_at(const Subject& subject, const BoxPrimitive& bounded, std::int32_t x, std::int32_t y,
                                    Count& count) {
  const view::PixelRect& pixels = subject.view.extents[bounded.primitive].pixels;
  if (x < pixels.x0 || x > pixels.x1 || y < pixels.y0 || y > pixels.y1) return std::nullopt;
  const std::size_t planes = bounded.planes.edges.size() + bounded.planes.fronts.size() + bounded.planes.backs.size();
  const std::uint64_t values = longs_of(subject.view.sampling) * planes;
  count(Operation::load_long, 3 * values);
  count(Operation::multiply, 4 * values);
  count(Operation::add_long, 4 * values);
  count(Operation::compare_long, values);
  count(Operation::branch_taken, planes);
  const auto at = [&](const view::FixedLinear& plane) { return plane.a * x + plane.b * y + plane.c; };
  for (const TilePlanes::Edge& edge : bounded.planes.edges) {
    if ((at(edge.linear) >= 0) != edge.positive) return std::nullopt;
  }
  const unsigned shift = subject.view.sampling.fraction_bits;
  Depths depths{0, subject.farthest()};
  for (const view::FixedLinear& plane : bounded.planes.fronts)
    depths.front = std::max(depths.front, at(plane) >> shift);
  for (const view::FixedLinear& plane : bounded.planes.backs) depths.back = std::min(depths.back, at(plane) >> shift);
  for (const facet::QuadricSide side : subject.geometry.solids[bounded.primitive].quadrics) {
    count_quadric(subject.view.quadrics[side.quadric], count);
    depths = intersect_quadric(depths, subject.view, side, x, y);
  }
  if (depths.front >= depths.back) return std::nullopt;
  return Interval{bounded.primitive, static_cast<std::uint32_t>(depths.front), static_cast<std::uint32_t>(depths.back)};
}

}  // namespace csgsim::software
