#include "host/emit/halfspaces.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "host/emit/near_cap.h"
#include "host/view/leading.h"
#include "hw/base/error.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using view::Side;

/// Throws InputError, naming the primitive, unless the machine can represent the plane's coefficients.
void require_representable(const Context& context, std::uint32_t primitive, facet::Halfspace halfspace) {
  if (context.view.planes[halfspace.plane].representable) return;
  throw InputError(model::location_text(context.tree, primitive) +
                   ": a face of this primitive is too large for the picture: its coefficients do not fit " +
                   std::to_string(isa::max_linear_width) +
                   " bits; move the camera back, move the picture's centre onto it, lower --z-bits or --fraction-bits, "
                   "or split the primitive");
}

/// Values compared for each half-space of a surface in a usual block.
constexpr double usual_values = 8;

csg::Containment locate_block(const Context& context, facet::Halfspace halfspace, const csg::Block& block) {
  context.counted.test(context.linear_plane(halfspace), block.pixels);
  const csg::Containment known = csg::locate(context.view, halfspace, block);
  const bool representable = context.view.planes[halfspace.plane].representable;
  return context.options.pruning.halfspaces || !representable ? known : csg::Containment::depends;
}

bool is_edge_test(const Context& context, facet::Halfspace halfspace, const csg::Block& block) {
  return context.view.planes[halfspace.plane].kind == view::PlaneKind::edge &&
         locate_block(context, halfspace, block) != csg::Containment::in;
}

template <class Item>
void keep(std::vector<Item>& items, const std::vector<bool>& kept) {
  std::size_t index = 0;
  std::erase_if(items, [&](const Item&) { return !kept[index++]; });
}

/// Drops half-spaces that some leader, the greatest rank at a corner, exceeds by a step at every corner, and hence at
/// every pixel.
void drop_before_leaders(std::vector<view::FixedLinear>& ranks, std::vector<Facet>& facets, std::int64_t step,
                         const view::PixelRect& pixels, const csg::Counted& counted) {
  std::uint64_t held = 0;
  const std::vector<bool> leads = view::leading(ranks, pixels, step, &held);
  counted.add(&isa::Preparation::values, held);
  keep(ranks, leads);
  keep(facets, leads);
}

/// Drops half-spaces that are at least a depth step behind the extreme at every pixel.
void drop_before_all(const std::vector<view::FixedLinear>& ranks, std::vector<Facet>& facets, std::int64_t step,
                     const view::PixelRect& pixels, const csg::Counted& counted) {
  std::vector<bool> kept(ranks.size(), false);
  std::vector<std::int64_t> extremes(static_cast<std::size_t>(pixels.x1 - pixels.x0 + 1));
  const auto along = [&](const view::FixedLinear& rank, std::int64_t y, const auto& visit) {
    counted.add(&isa::Preparation::values, extremes.size());
    std::int64_t value = rank.a * pixels.x0 + rank.b * y + rank.c;
    for (std::int64_t& extreme : extremes) {
      visit(value, extreme);
      value += rank.a;
    }
  };
  for (std::int64_t y = pixels.y0; y <= pixels.y1; ++y) {
    extremes.assign(extremes.size(), std::numeric_limits<std::int64_t>::min());
    for (const view::FixedLinear& rank : ranks)
      along(rank, y, [](std::int64_t value, std::int64_t& extreme) { extreme = std::max(extreme, value); });
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      if (kept[i]) continue;
      bool near = false;
      along(ranks[i], y, [&](std::int64_t value, std::int64_t extreme) { near = near || value + step > extreme; });
      kept[i] = near;
    }
  }
  keep(facets, kept);
}

/// Drops half-spaces that never form the extreme of their side, because another one exceeds them by at least a depth
/// step at every pixel.
void drop_dominated(const Context& context, std::vector<Facet>& facets, Side side, const view::PixelRect& pixels) {
  const std::int64_t sign = side == Side::front ? 1 : -1;
  const std::int64_t step = std::int64_t{1} << context.view.sampling.fraction_bits;
  std::vector<view::FixedLinear> ranks;
  for (const Facet& facet : facets) {
    const view::FixedLinear& plane = context.linear_plane(facet.halfspace);
    ranks.push_back({sign * plane.a, sign * plane.b, sign * plane.c});
  }
  drop_before_leaders(ranks, facets, step, pixels, context.counted);
  if (context.options.pruning.pixels && facets.size() > 1)
    drop_before_all(ranks, facets, step, pixels, context.counted);
}

}  // namespace

DecidingFacets cutting_facets(const Context& context, std::span<const std::uint32_t> set, Side side,
                              const csg::Block& block) {
  DecidingFacets result;
  for (const std::uint32_t primitive : set) {
    for (const facet::Halfspace& halfspace : context.geometry.solids[primitive].halfspaces) {
      if (view::side_of(context.view.planes[halfspace.plane], halfspace) != side) continue;
      const csg::Containment known = locate_block(context, halfspace, block);
      if (known == csg::Containment::in) continue;
      result.nothing = result.nothing || known == csg::Containment::out;
      if (known == csg::Containment::depends) require_representable(context, primitive, halfspace);
      result.facets.push_back({primitive, halfspace});
    }
  }
  return result;
}

DecidingFacets deciding_facets(const Context& context, std::span<const std::uint32_t> set, Side side,
                               const csg::Block& block) {
  DecidingFacets result = cutting_facets(context, set, side, block);
  const auto count = static_cast<double>(result.facets.size());
  const csg::Prices& prices = context.options.prices;
  if (context.options.pruning.halfspaces && !result.nothing && count > 1 &&
      prices.is_worthwhile(count, count * usual_values * prices.value)) {
    drop_dominated(context, result.facets, side, block.pixels);
  }
  return result;
}

std::uint32_t Sides::count() const {
  return static_cast<std::uint32_t>(fronts.facets.size() + backs.facets.size() + quadrics.size()) + edges;
}

namespace {

/// Whether the quadric is what a solid shows at depth 0, and it may be there.
bool is_seen_at_near(const Context& context, const PlannedSurface& planned, const QuadricBound& bound) {
  return bound.primitive == planned.primitive() && !context.complemented(planned.primitive()) &&
         is_near_facet(context, bound) && may_reach_near(context, bound, planned.block.pixels);
}

}  // namespace

Sides deciding_sides(const Context& context, const PlannedSurface& planned) {
  const csg::Block column{planned.block.pixels, 0, context.farthest()};
  Sides sides{column, deciding_facets(context, planned.set, Side::front, column),
              deciding_facets(context, planned.set, Side::back, column)};
  for (const std::uint32_t primitive : planned.set) {
    const std::vector<facet::Halfspace>& halfspaces = context.geometry.solids[primitive].halfspaces;
    sides.edges += static_cast<std::uint32_t>(
        std::count_if(halfspaces.begin(), halfspaces.end(),
                      [&](const facet::Halfspace& halfspace) { return is_edge_test(context, halfspace, column); }));
    for (const QuadricBound& bound : quadric_bounds(context, primitive)) {
      const csg::Containment known = locate_block(context, bound, column);
      sides.nothing = sides.nothing || known == csg::Containment::out;
      if (known == csg::Containment::in && !is_seen_at_near(context, planned, bound)) continue;
      if (bound.role == view::QuadricRole::edge) {
        ++sides.edges;
      } else {
        sides.quadrics.push_back(bound);
      }
    }
  }
  return sides;
}

isa::Origin facet_origin(isa::Purpose purpose, const PlannedSurface& planned, const Facet& facet) {
  return {purpose, facet.primitive, planned.set.size() > 1 ? planned.primitive() : isa::no_node};
}

std::optional<Facet> visible_facet(const QuadricBound& bound, bool complemented) {
  using view::QuadricRole;
  const auto facet = [&](At at) { return Facet{bound.primitive, {}, at, bound.side}; };
  switch (bound.role) {
    case QuadricRole::between: return facet(complemented ? At::quadric_far : At::quadric_near);
    case QuadricRole::until: return complemented ? std::optional(facet(At::quadric_near)) : std::nullopt;
    case QuadricRole::from: return complemented ? std::nullopt : std::optional(facet(At::quadric_far));
    case QuadricRole::edge: break;
  }
  return std::nullopt;
}

view::FixedLinear facet_plane(const Context& context, const Facet& facet) {
  return facet.at != At::plane ? view::FixedLinear{} : context.linear_plane(facet.halfspace);
}

bool has_edges(const Context& context, std::uint32_t primitive, const csg::Block& block) {
  const auto cuts = [&](const facet::Halfspace& halfspace) { return is_edge_test(context, halfspace, block); };
  const auto cuts_too = [&](const QuadricBound& bound) {
    return bound.role == view::QuadricRole::edge && locate_block(context, bound, block) != csg::Containment::in;
  };
  return std::ranges::any_of(context.geometry.solids[primitive].halfspaces, cuts) ||
         std::ranges::any_of(quadric_bounds(context, primitive), cuts_too);
}

void emit_edges(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block) {
  for (const facet::Halfspace& halfspace : context.geometry.solids[primitive].halfspaces) {
    if (!is_edge_test(context, halfspace, block)) continue;
    const view::ScreenPlane& plane = context.view.planes[halfspace.plane];
    require_representable(context, primitive, halfspace);
    const bool positive = view::side_of(plane, halfspace) == Side::edge_positive;
    out.edge(positive ? isa::Opcode::edge_not_negative : isa::Opcode::edge_negative, plane.linear, block.pixels);
  }
  for (const QuadricBound& bound : quadric_bounds(context, primitive)) {
    if (bound.role == view::QuadricRole::edge && locate_block(context, bound, block) != csg::Containment::in)
      emit_outline(context, out, bound, block.pixels);
  }
}

}  // namespace csgsim::emit
