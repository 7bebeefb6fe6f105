#include "host/effects/shadow_receivers.h"

#include <algorithm>
#include <cstdint>

#include "host/effects/plane_comparison.h"
#include "host/emit/drawing.h"
#include "host/emit/shading.h"
#include "host/emit/surface.h"

namespace csgsim::effects {

namespace {

using view::FixedLinear;
using view::Side;

FixedLinear negated(const FixedLinear& line, std::int64_t more) { return {-line.a, -line.b, -line.c + more}; }

/// The outline of the visible part of a facet. There the facet is the farthest front and before all backs or, on a
/// subtracted solid, the nearest back and behind all fronts.
Outline visible_outline(const emit::Context& context, const emit::PlannedSurface& planned, const emit::Sides& sides,
                        const emit::Facet& facet) {
  const FixedLinear& plane = context.linear_plane(facet.halfspace);
  const PlaneComparison compared(plane, context.view.sampling.fraction_bits);
  const bool complemented = context.complemented(planned.primitive());
  Outline outline(planned.block.pixels);
  const auto keep = [&](const FixedLinear& line) { outline = outline.clipped(line); };
  const unsigned fraction_bits = context.view.sampling.fraction_bits;
  keep({plane.a, plane.b, plane.c - (planned.block.z_low << fraction_bits)});
  keep(negated(plane, ((planned.block.z_high + 1) << fraction_bits) - 1));
  for (const emit::Facet& front : sides.fronts.facets)
    keep(compared.in({Side::front, complemented, context.linear_plane(front.halfspace)}));
  for (const emit::Facet& back : sides.backs.facets) {
    const ShadowPlane half{Side::back, false, context.linear_plane(back.halfspace)};
    // The nearest back is in front of the other backs or coincides with them.
    keep(complemented ? compared.out({Side::front, true, half.linear}) : compared.in(half));
  }
  for (const std::uint32_t primitive : planned.set) {
    for (const facet::Halfspace& halfspace : context.geometry.solids[primitive].halfspaces) {
      const view::ScreenPlane& edge = context.view.planes[halfspace.plane];
      if (edge.kind == view::PlaneKind::edge && edge.representable)
        keep(compared.in({view::side_of(edge, halfspace), false, edge.linear}));
    }
  }
  return outline;
}

}  // namespace

Receivers find_receivers(const emit::Context& context, std::size_t light) {
  Receivers receivers;
  for (const emit::PlannedSurface& planned : context.plan.surfaces) {
    if (!emit::is_drawn(context, planned)) continue;
    const emit::Sides sides = emit::deciding_sides(context, planned);
    const emit::Surface surface = emit::plan_surface(context, planned, sides);
    if (surface.nothing) continue;
    for (const emit::Facet& facet : surface.facets) {
      if (facet.at != emit::At::plane) continue;
      if (!emit::light_matters(context, facet, planned.block.pixels, light)) continue;
      Outline outline = visible_outline(context, planned, sides, facet);
      if (!outline.empty())
        receivers.facets.push_back(
            {facet.primitive, facet.halfspace, context.linear_plane(facet.halfspace), std::move(outline)});
    }
  }
  return receivers;
}

}  // namespace csgsim::effects
