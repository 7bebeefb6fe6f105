#include "sim/software/facets/screen_facets.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "host/view/region.h"
#include "host/view/rivals.h"
#include "sim/software/rays/tile_planes.h"

namespace csgsim::software {

namespace {

using view::difference;
using view::FixedLinear;

/// A function that is >= 0 where the edge test passes.
FixedLinear passed(const TilePlanes::Edge& edge) {
  if (edge.positive) return edge.linear;
  return {-edge.linear.a, -edge.linear.b, -edge.linear.c - 1};
}

/// A primitive's planes along rays: without front planes, the front is the near cap at depth 0.
view::Boundary boundary_of(TilePlanes planes) {
  view::Boundary boundary{std::move(planes.fronts), std::move(planes.backs), {}};
  if (boundary.fronts.empty()) boundary.fronts.emplace_back();
  for (const TilePlanes::Edge& edge : planes.edges) boundary.edges.push_back(passed(edge));
  return boundary;
}

/// Creates the screen facets of one primitive.
class Maker {
 public:
  Maker(const view::View& view, std::uint32_t primitive, TilePlanes planes, ScreenFacets& made)
      : primitive_(primitive),
        has_near_cap_(planes.fronts.empty()),
        boundary_(boundary_of(std::move(planes))),
        rivals_(view::rivals(boundary_, view.extents[primitive].pixels, 0)),
        made_(made) {}

  void add_near_cap() {
    if (has_near_cap_) add_front(ScreenFacet::near_cap, 0);
  }
  /// Adds the front or back facet with index `place` among those of its side.
  void add_front(std::uint32_t facet, std::uint32_t place) {
    const view::Rivals& rivals = rivals_.of_fronts[place];
    add({.facet = facet, .depth = boundary_.fronts[place]}, place, rivals, rivals.fronts, rivals.backs);
  }
  void add_back(std::uint32_t facet, std::uint32_t place) {
    const view::Rivals& rivals = rivals_.of_backs[place];
    // Depths before 0 are not events, with or without the near cap.
    static const std::vector<std::uint32_t> none;
    add({.facet = facet, .leaves = true, .depth = boundary_.backs[place]}, place, rivals, rivals.backs,
        has_near_cap_ ? none : rivals.fronts);
  }

 private:
  void bound(const FixedLinear& linear) {
    if (!region_.clip(linear)) made_.linears.push_back(linear);
  }

  /// Bounds the region by the rivals on the facet's own side and on the opposite side.
  void bound(const ScreenFacet& facet, std::uint32_t place, const std::vector<std::uint32_t>& same,
             const std::vector<std::uint32_t>& others) {
    for (const std::uint32_t i : same) {
      if (region_.empty()) return;
      const FixedLinear& one = facet.leaves ? boundary_.backs[i] : boundary_.fronts[i];
      const std::int64_t more = i < place ? -1 : 0;
      bound(facet.leaves ? difference(one, facet.depth, more) : difference(facet.depth, one, more));
    }
    for (const std::uint32_t i : others) {
      if (region_.empty()) return;
      bound(thickness(facet, opposite(facet, i), -1));
    }
  }

  void add(ScreenFacet facet, std::uint32_t place, const view::Rivals& rivals, const std::vector<std::uint32_t>& same,
           const std::vector<std::uint32_t>& others) {
    region_ = view::Region(rivals.pixels);
    facet.primitive = primitive_;
    facet.bounds = made_.linears.size();
    for (const std::uint32_t i : rivals.edges) bound(boundary_.edges[i]);
    bound(facet, place, same, others);
    facet.pixels = view::common(region_.pixels(), rivals.pixels);
    if (region_.empty() || facet.pixels.empty()) {
      made_.linears.resize(facet.bounds);
      return;
    }
    leave_out_slack(facet.bounds);
    facet.opposites = made_.linears.size();
    if (!covers_pixel(facet)) {
      made_.linears.resize(facet.bounds);
      return;
    }
    for (const std::uint32_t i : others) {
      const FixedLinear& other = opposite(facet, i);
      if (!is_surely_behind(facet, other)) made_.linears.push_back(other);
    }
    facet.end = made_.linears.size();
    made_.facets.push_back(facet);
  }

  /// Rivals bound the facet at pixels only; between pixels it may extend far beyond its position.
  [[nodiscard]] bool covers_pixel(const ScreenFacet& facet) const {
    for (std::int32_t row = facet.pixels.y0; row <= facet.pixels.y1; ++row) {
      if (!made_.span_of(facet, row).empty()) return true;
    }
    return false;
  }

  [[nodiscard]] const FixedLinear& opposite(const ScreenFacet& facet, std::uint32_t number) const {
    return facet.leaves ? boundary_.fronts[number] : boundary_.backs[number];
  }

  /// Removes bounds that no longer matter after later cuts: a constraint that is positive throughout a convex region
  /// does not bound it.
  void leave_out_slack(std::size_t begin) {
    const auto first = made_.linears.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto is_slack = [&](const FixedLinear& bound) { return region_.is_certainly_at_least(bound, 1); };
    made_.linears.erase(std::remove_if(first, made_.linears.end(), is_slack), made_.linears.end());
  }

  /// Whether a facet and one of the opposite side are at least a step apart at every pixel, and the remaining interval
  /// starts no nearer than depth 0.
  [[nodiscard]] bool is_surely_behind(const ScreenFacet& facet, const FixedLinear& other) const {
    const double step = static_cast<double>(std::int64_t{1} << made_.fraction_bits);
    return region_.is_certainly_at_least(thickness(facet, other), step) &&
           (facet.leaves || region_.is_certainly_at_least(other, step));
  }

  static FixedLinear thickness(const ScreenFacet& facet, const FixedLinear& other, std::int64_t more = 0) {
    return facet.leaves ? difference(facet.depth, other, more) : difference(other, facet.depth, more);
  }

  std::uint32_t primitive_;
  bool has_near_cap_;
  view::Boundary boundary_;
  view::AllRivals rivals_;
  ScreenFacets& made_;
  view::Region region_{view::PixelRect{}};
};

void add_facets(const view::View& view, const Facets& facets, std::uint32_t primitive, TilePlanes planes,
                ScreenFacets& made) {
  if (planes.nowhere || view.extents[primitive].pixels.empty()) return;
  Maker maker(view, primitive, std::move(planes), made);
  maker.add_near_cap();
  std::uint32_t fronts = 0;
  std::uint32_t backs = 0;
  for (std::size_t i = facets.of_primitives[primitive]; i < facets.of_primitives[primitive + 1]; ++i) {
    const facet::Halfspace halfspace = facets.facets[i].halfspace;
    const view::ScreenPlane& plane = view.planes[halfspace.plane];
    if (!plane.representable) continue;
    const auto facet = static_cast<std::uint32_t>(i);
    const view::Side side = view::side_of(plane, halfspace);
    if (side == view::Side::front) maker.add_front(facet, fronts++);
    if (side == view::Side::back) maker.add_back(facet, backs++);
  }
}

}  // namespace

Span ScreenFacets::span_of(const ScreenFacet& facet, std::int32_t row) const {
  Span span{facet.pixels.x0, facet.pixels.x1};
  if (row < facet.pixels.y0 || row > facet.pixels.y1) return {};
  for (const FixedLinear& bound : bounds_of(facet)) {
    if (span.empty()) break;
    clip(span, bound.a, bound.b * row + bound.c);
  }
  return span;
}

std::optional<Event> ScreenFacets::event_at(const ScreenFacet& facet, std::int32_t column, std::int32_t row,
                                            std::int64_t value) const {
  const std::int64_t depth = facet.leaves ? value >> fraction_bits : std::max<std::int64_t>(0, value >> fraction_bits);
  if (facet.leaves && depth <= 0) return std::nullopt;
  if (depth >= farthest) return std::nullopt;
  for (const FixedLinear& opposite : opposites_of(facet)) {
    const std::int64_t other = value_at(opposite, column, row) >> fraction_bits;
    if (facet.leaves ? other >= depth : depth >= other) return std::nullopt;
  }
  return Event{static_cast<std::uint32_t>(depth), facet.crossing()};
}

std::optional<Event> ScreenFacets::event_at(const ScreenFacet& facet, std::int32_t column, std::int32_t row) const {
  const view::PixelRect& pixels = facet.pixels;
  if (column < pixels.x0 || column > pixels.x1 || row < pixels.y0 || row > pixels.y1) return std::nullopt;
  for (const FixedLinear& bound : bounds_of(facet)) {
    if (value_at(bound, column, row) < 0) return std::nullopt;
  }
  return event_at(facet, column, row, value_at(facet.depth, column, row));
}

ScreenFacets screen_facets(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                           const Facets& facets) {
  ScreenFacets made;
  made.fraction_bits = view.sampling.fraction_bits;
  made.farthest = (std::uint32_t{1} << view.sampling.z_bits) - 1;
  for (std::uint32_t primitive = 0; primitive < geometry.solids.size(); ++primitive) {
    made.of_primitives.push_back(made.facets.size());
    add_facets(view, facets, primitive, planes_of(tree, geometry, view, primitive), made);
  }
  made.of_primitives.push_back(made.facets.size());
  return made;
}

}  // namespace csgsim::software
