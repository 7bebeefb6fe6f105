#include "host/csg/locate.h"

#include <algorithm>
#include <cmath>

#include "hw/isa/host_counts.h"

namespace csgsim::csg {

namespace {

/// A bound beyond all values that the machine uses, for planes whose coefficients do not fit.
constexpr double beyond = 1e15;

void count_test(const view::View& view, const facet::Halfspace& bound, const view::PixelRect& pixels,
                const Counted& counted) {
  counted.test(view.planes[bound.plane].linear, pixels);
}

void count_test(const view::View& /*view*/, const facet::QuadricSide& /*bound*/, const view::PixelRect& /*pixels*/,
                const Counted& counted) {
  counted.add(&isa::Preparation::halfspaces, tests_of_quadric);
}

std::int64_t clamp_to_integer(double value) { return static_cast<std::int64_t>(std::clamp(value, -beyond, beyond)); }

/// The range of an unrounded plane, wider at both ends by a step more than any rounding.
view::Range real_range(const view::View& view, const view::RealLinear& linear, const view::PixelRect& pixels) {
  const double cx = (view.sampling.width - 1.0) / 2.0;
  const double cy = (view.sampling.height - 1.0) / 2.0;
  double low = linear.at_centre;
  double high = linear.at_centre;
  const auto widen = [&](double slope, double first, double last) {
    low += std::min(slope * first, slope * last);
    high += std::max(slope * first, slope * last);
  };
  widen(linear.a, pixels.x0 - cx, pixels.x1 - cx);
  widen(linear.b, pixels.y0 - cy, pixels.y1 - cy);
  const double slack = 1.0 + 1e-9 * std::max(std::abs(low), std::abs(high));
  return {clamp_to_integer(std::floor(low - slack)), clamp_to_integer(std::ceil(high + slack))};
}

}  // namespace

view::Range depth_range(const view::ScreenPlane& plane, unsigned fraction_bits, const view::PixelRect& pixels) {
  const view::Range exact = view::range_over(plane.linear, pixels);
  return {exact.low >> fraction_bits, exact.high >> fraction_bits};
}

Containment locate(const view::View& view, facet::Halfspace halfspace, const Block& block) {
  return locate(view, view.planes[halfspace.plane], halfspace.positive, block);
}

Containment locate(const view::View& view, const view::ScreenPlane& plane, bool positive, const Block& block) {
  const auto range = [&] {
    if (!plane.representable) return real_range(view, plane.real, block.pixels);
    return plane.kind == view::PlaneKind::edge ? view::range_over(plane.linear, block.pixels)
                                               : depth_range(plane, view.sampling.fraction_bits, block.pixels);
  }();
  switch (view::side_of(plane, positive)) {
    case view::Side::front:
      if (range.high <= block.z_low) return Containment::in;
      return range.low > block.z_high ? Containment::out : Containment::depends;
    case view::Side::back:
      if (range.low > block.z_high) return Containment::in;
      return range.high <= block.z_low ? Containment::out : Containment::depends;
    case view::Side::edge_positive:
      if (range.low >= 0) return Containment::in;
      return range.high < 0 ? Containment::out : Containment::depends;
    case view::Side::edge_negative:
      if (range.high < 0) return Containment::in;
      return range.low >= 0 ? Containment::out : Containment::depends;
  }
  return Containment::depends;
}

Containment locate(const view::View& view, facet::QuadricSide side, const Block& block) {
  const view::ScreenQuadric& quadric = view.quadrics[side.quadric];
  if (quadric.kind == view::ScreenQuadricKind::unfit) return Containment::depends;
  const view::RootRanges ranges = view::ranges_over(quadric, view.sampling.fraction_bits, block.pixels);
  const bool all = ranges.discriminant.low >= 0;
  const bool none = ranges.discriminant.high < 0;
  const auto known = [](bool in, bool out) {
    return in ? Containment::in : out ? Containment::out : Containment::depends;
  };
  switch (view::role_of(quadric, side)) {
    case view::QuadricRole::between:
      return known(all && ranges.near.high <= block.z_low && ranges.far.low > block.z_high,
                   none || ranges.near.low > block.z_high || ranges.far.high <= block.z_low);
    case view::QuadricRole::until:
      return known(none || ranges.near.low > block.z_high, all && ranges.near.high <= block.z_low);
    case view::QuadricRole::from:
      return known(all && ranges.far.high <= block.z_low, none || ranges.far.low > block.z_high);
    case view::QuadricRole::edge: return known(all, none);
  }
  return Containment::depends;
}

Containment locate(const view::View& view, const facet::Geometry& geometry, std::uint32_t primitive, const Block& block,
                   const Counted& counted, Excluder* excluder) {
  if (excluder != nullptr) excluder->held = false;
  counted.add(&isa::Preparation::boxes);
  const view::Extent& extent = view.extents[primitive];
  const view::PixelRect shared = common(extent.pixels, block.pixels);
  if (extent.empty() || shared.empty() || extent.z_low > block.z_high || extent.z_high < block.z_low)
    return Containment::out;
  bool inside = shared == block.pixels;
  const Block part{shared, block.z_low, block.z_high};
  const auto is_out = [&](const auto& bound) {
    count_test(view, bound, shared, counted);
    const Containment known = locate(view, bound, part);
    inside = inside && known == Containment::in;
    return known == Containment::out;
  };
  const facet::Convex& solid = geometry.solids[primitive];
  const std::size_t first = excluder == nullptr ? model::no_index : excluder->halfspace;
  if (first < solid.halfspaces.size() && is_out(solid.halfspaces[first])) {
    excluder->held = true;
    return Containment::out;
  }
  for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) {
    if (i == first || !is_out(solid.halfspaces[i])) continue;
    if (excluder != nullptr) excluder->halfspace = static_cast<std::uint32_t>(i);
    return Containment::out;
  }
  if (std::ranges::any_of(solid.quadrics, is_out)) return Containment::out;
  return inside ? Containment::in : Containment::depends;
}

bool holds(const view::View& view, const facet::Geometry& geometry, std::uint32_t primitive, const Block& block,
           const Counted& counted) {
  counted.add(&isa::Preparation::boxes);
  const view::Extent& extent = view.extents[primitive];
  const bool is_inside = !block.pixels.empty() && !extent.empty() &&
                         common(extent.pixels, block.pixels) == block.pixels && extent.z_low <= block.z_high &&
                         extent.z_high >= block.z_low;
  const auto holds_block = [&](const auto& bound) {
    count_test(view, bound, block.pixels, counted);
    return locate(view, bound, block) == Containment::in;
  };
  const facet::Convex& solid = geometry.solids[primitive];
  return is_inside && std::ranges::all_of(solid.halfspaces, holds_block) &&
         std::ranges::all_of(solid.quadrics, holds_block);
}

}  // namespace csgsim::csg
