#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/emit/drawing.h"
#include "host/emit/early_out.h"
#include "host/emit/levels.h"
#include "host/emit/shading.h"
#include "host/emit/strategy.h"
#include "host/view/region.h"
#include "host/view/rivals.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;
using view::difference;
using view::FixedLinear;

/// A plane that a face is compared with.
struct Neighbour {
  Opcode opcode;  ///< E stays 1 where this comparison of the plane with Z1, the face's depth, holds
  FixedLinear plane;
};

/// The neighbours of the faces of one surface.
class Faces {
 public:
  Faces(const Context& context, const Sides& sides, const Surface& surface)
      : pixels_(surface.block.pixels),
        step_(std::int64_t{1} << context.view.sampling.fraction_bits),
        boundary_(make_boundary(context, sides, surface)),
        rivals_(view::rivals(boundary_, pixels_, context.view.sampling.fraction_bits)) {}

  /// The neighbours of a face. If the face covers no pixel, there are none and the region is empty.
  [[nodiscard]] std::vector<Neighbour> around(std::uint32_t face, view::Region& region) const {
    const FixedLinear& own = boundary_.fronts[face];
    const view::Rivals& rivals = rivals_.of_fronts[face];
    region = view::Region(rivals.pixels.empty() ? view::PixelRect{} : pixels_);
    // Depths that differ by less than a step may be rounded to the same depth.
    const auto leave = [&](const FixedLinear& near, const FixedLinear& far) {
      region.clip(difference(far, near, step_ - 1));
    };
    for (const std::uint32_t i : rivals.fronts) leave(boundary_.fronts[i], own);
    for (const std::uint32_t i : rivals.backs) leave(own, boundary_.backs[i]);
    std::vector<Neighbour> neighbours;
    const auto add = [&](Opcode opcode, const FixedLinear& plane, const FixedLinear& thickness) {
      if (!region.is_certainly_at_least(thickness, static_cast<double>(step_))) neighbours.push_back({opcode, plane});
    };
    // Among faces at the same depth, the first is visible.
    for (const std::uint32_t i : rivals.fronts) {
      const FixedLinear& front = boundary_.fronts[i];
      add(i < face ? Opcode::linear_lt : Opcode::linear_le, front, difference(own, front));
    }
    for (const std::uint32_t i : rivals.backs)
      add(Opcode::linear_gt, boundary_.backs[i], difference(boundary_.backs[i], own));
    return neighbours;
  }

 private:
  static view::Boundary make_boundary(const Context& context, const Sides& sides, const Surface& surface) {
    view::Boundary boundary;
    for (const Facet& front : surface.facets) boundary.fronts.push_back(context.linear_plane(front.halfspace));
    for (const Facet& back : sides.backs.facets) boundary.backs.push_back(context.linear_plane(back.halfspace));
    return boundary;
  }

  view::PixelRect pixels_;
  std::int64_t step_;
  view::Boundary boundary_;
  view::AllRivals rivals_;
};

/// Writes the depth and colour of a face where E is 1 and it is nearer than Z2.
void emit_face(const Context& context, Broadcast& out, const PlannedSurface& planned, const Facet& facet,
               const std::vector<Neighbour>& neighbours, const view::PixelRect& pixels) {
  const Layout& layout = context.layout;
  out.origin = facet_origin(isa::Purpose::render, planned, facet);
  out.surface(Opcode::load_linear, layout.candidate, context.linear_plane(facet.halfspace), pixels);
  for (const Neighbour& one : neighbours) out.surface(one.opcode, layout.candidate, one.plane, pixels);
  const isa::Origin merging = facet_origin(isa::Purpose::merge, planned, facet);
  out.origin = merging;
  out.plain(Opcode::field_lt, layout.candidate, layout.depth);
  const std::size_t merge = out.size();
  out.plain(Opcode::copy, layout.depth, layout.candidate);
  out.origin = facet_origin(isa::Purpose::shade, planned, facet);
  emit_colour(context, out, facet, layout.colour, pixels);
  emit_early_out(context, out, merge, merging);
}

/// Whether the surface is drawn face by face: it is compared with nothing but its own faces, all of them are flat, the
/// near plane cuts none, and flat shading is the only effect.
bool has_polygons(const Context& context, const PlannedSurface& planned, const Surface& surface) {
  const bool is_plain = context.called.size() <= 1 && context.base.width == 0 && context.beyond.width == 0 &&
                        context.beyond_plane == nullptr && context.paint == nullptr && context.layout.owner.width == 0;
  return is_plain && planned.active.operands.empty() && !context.complemented(planned.primitive()) &&
         std::ranges::all_of(planned.set,
                             [&](std::uint32_t one) { return context.geometry.solids[one].quadrics.empty(); }) &&
         std::ranges::all_of(surface.facets, [](const Facet& facet) { return facet.at == At::plane; });
}

/// Draws the visible part of the surface, each face separately where it is nearer than Z2. A face is its plane clipped
/// by those of its neighbours (thesis 7.2.1 and 8.2), which are compared by the machine's rounded depths, so that each
/// pixel gets the face that emit_surface finds there. Planes that the face does not come near are skipped.
void emit_polygons(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides,
                   const Surface& surface) {
  const view::PixelRect& pixels = surface.block.pixels;
  out.origin = {isa::Purpose::render, planned.primitive(), isa::no_node};
  enable_drawing(context, out);
  out.clip(pixels, context.plan.pixels());
  for (const std::uint32_t primitive : planned.set) emit_edges(context, out, primitive, sides.column);
  out.plain(Opcode::enable_store, context.layout.mask);
  const Faces faces(context, sides, surface);
  view::Region region{pixels};
  for (std::uint32_t i = 0; i < surface.facets.size(); ++i) {
    const std::vector<Neighbour> neighbours = faces.around(i, region);
    if (region.empty()) continue;
    out.origin = facet_origin(isa::Purpose::render, planned, surface.facets[i]);
    out.plain(Opcode::enable_load, context.layout.mask);
    emit_face(context, out, planned, surface.facets[i], neighbours, pixels);
    ++out.counts.depth_tests;
  }
  out.counts.rendered += planned.set.size();
}

bool draw_polygons(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const Surface surface = plan_surface(context, planned, sides);
  if (surface.nothing) return true;
  if (!has_polygons(context, planned, surface)) return false;
  emit_polygons(context, out, planned, sides, surface);
  return true;
}

}  // namespace

/// Thesis 7.2.1 and 8.2: surfaces that are compared with nothing are drawn face by face, the rest as by `stack`.
extern const StrategyRow polygons_strategy{.bits = bits_for_all_levels,
                                           .classify = emit_by_all_levels,
                                           .draw = draw_polygons,
                                           .is_tried = false,
                                           .is_usual = false};

}  // namespace csgsim::emit
