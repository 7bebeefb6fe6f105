#include "host/emit/surface.h"

#include <algorithm>

#include "host/emit/effect.h"
#include "host/emit/halfspaces.h"
#include "host/emit/near_cap.h"
#include "host/emit/shading.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;

/// Whether the facet fits Z1 wherever it is, before the other bound of the depth range too.
bool fits(const Context& context, const Facet& facet, const csg::Block& block, bool farthest_front) {
  const view::Range range = context.range_of(facet.halfspace, block.pixels);
  return farthest_front ? range.low >= 0 : range.high <= context.farthest();
}

/// The extreme of the facets into Z1: the farthest of the fronts, or the nearest of the backs of a complemented
/// primitive. Starts from depth 0 if it may be there, else from a facet that fits Z1, else from the bound of the depth
/// range.
class Extreme {
 public:
  Extreme(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface)
      : context_(context),
        out_(out),
        planned_(planned),
        surface_(surface),
        farthest_front_(!context.complemented(planned.primitive())),
        first_(std::find_if(surface.facets.begin(), surface.facets.end(),
                            [](const Facet& facet) { return facet.at != At::plane; })) {
    if (first_ != surface.facets.end()) return;
    first_ = std::find_if(surface.facets.begin(), surface.facets.end(),
                          [&](const Facet& facet) { return fits(context, facet, surface.block, farthest_front_); });
  }

  /// Without colours.
  void emit() {
    start();
    for (auto facet = surface_.facets.begin(); facet != surface_.facets.end(); ++facet) {
      if (facet == first_) continue;
      out_.surface(farthest_front_ ? Opcode::keep_max : Opcode::keep_min, context_.layout.candidate,
                   context_.linear_of(facet->halfspace), surface_.block.pixels);
    }
  }

  /// With colours beside: E is taken from the mask anew for each facet. Of facets at the same depth the first counts:
  /// what stands after the start replaces less than it, in order; what stands before the start replaces equals too,
  /// backwards.
  void emit_with_colours() {
    const auto begin = surface_.facets.begin();
    const auto end = surface_.facets.end();
    start();
    out_.plain(Opcode::enable_store, context_.layout.mask);
    set_colour(first_ != end ? *first_ : *(end - 1));
    for (auto facet = first_; facet != end && ++facet != end;) replace_by(*facet, false);
    for (auto facet = first_; facet != begin;) replace_by(*--facet, true);
    out_.plain(Opcode::enable_load, context_.layout.mask);
  }

 private:
  void start() {
    const isa::Field z1 = context_.layout.candidate;
    if (first_ != surface_.facets.end() && first_->at == At::plane) {
      out_.surface(Opcode::load_linear, z1, context_.linear_of(first_->halfspace), surface_.block.pixels);
    } else {
      out_.plain(Opcode::set_constant, z1, {}, farthest_front_ ? 0 : static_cast<std::uint64_t>(context_.farthest()));
    }
  }

  /// The facet's depth and colour where it is more extreme than Z1, or equal.
  void replace_by(const Facet& facet, bool equals_too) {
    const view::FixedLinear& plane = context_.linear_of(facet.halfspace);
    const view::PixelRect& pixels = surface_.block.pixels;
    out_.plain(Opcode::enable_load, context_.layout.mask);
    const view::Range range = context_.range_of(facet.halfspace, pixels);
    if (farthest_front_ && range.high > context_.farthest()) {
      // Beyond the farthest depth there is no surface.
      const std::int64_t beyond = (context_.farthest() + 1) << context_.view.sampling.fraction_bits;
      out_.edge(Opcode::edge_negative, {plane.a, plane.b, plane.c - beyond}, pixels);
      out_.plain(Opcode::enable_store, context_.layout.mask);
    } else if (!farthest_front_ && range.low < 0) {
      out_.edge(Opcode::edge_not_negative, plane, pixels);
      out_.plain(Opcode::enable_store, context_.layout.mask);
    }
    const Opcode strictly = farthest_front_ ? Opcode::linear_gt : Opcode::linear_lt;
    const Opcode or_equal = farthest_front_ ? Opcode::linear_ge : Opcode::linear_le;
    out_.surface(equals_too ? or_equal : strictly, context_.layout.candidate, plane, pixels);
    out_.surface(Opcode::load_linear, context_.layout.candidate, plane, pixels);
    set_colour(facet);
  }

  void set_colour(const Facet& facet) {
    const isa::Origin origin = out_.origin;
    out_.origin = origin_of(isa::Purpose::shade, planned_, facet);
    emit_colour(context_, out_, facet, context_.layout.candidate_colour, surface_.block.pixels);
    out_.origin = origin;
  }

  const Context& context_;
  Broadcast& out_;
  const PlannedSurface& planned_;
  const Surface& surface_;
  bool farthest_front_;
  std::vector<Facet>::const_iterator first_;
};

/// A subtracted solid has no back where it ends before the near plane.
void emit_near_test(const Context& context, Broadcast& out, const Surface& surface) {
  const bool reaches = std::any_of(surface.facets.begin(), surface.facets.end(), [&](const Facet& back) {
    return context.range_of(back.halfspace, surface.block.pixels).low <= 0;
  });
  if (reaches) out.surface(Opcode::linear_lt, context.layout.candidate, {0, 0, 0}, surface.block.pixels);
}

}  // namespace

Surface surface_of(const Context& context, const PlannedSurface& planned, const Sides& sides) {
  const csg::Block& block = planned.block;
  const bool complemented = context.complemented(planned.primitive());
  Surface surface{false, complemented ? sides.backs.facets : sides.fronts.facets, block, 0};
  surface.nothing = sides.fronts.nothing || sides.backs.nothing || (complemented && surface.facets.empty());
  if (surface.nothing) return surface;
  if (!complemented && may_reach_near(context, sides.fronts.facets, block))
    surface.facets.insert(surface.facets.begin(), at_near(context, planned.primitive()));
  return surface;
}

Surface emit_surface(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const csg::Block& block = planned.block;
  const bool complemented = context.complemented(planned.primitive());
  Surface surface = surface_of(context, planned, sides);
  if (surface.nothing) return surface;
  out.origin = {isa::Purpose::render, planned.primitive(), isa::no_node};
  enable_drawing(context, out);
  out.clip(block.pixels, context.plan.pixels());
  surface.begin = out.size();
  for (const std::uint32_t primitive : planned.set) emit_edges(context, out, primitive, sides.column);
  Extreme extreme(context, out, planned, surface);
  context.layout.candidate_colour.width > 0 ? extreme.emit_with_colours() : extreme.emit();
  for (const Facet& other : complemented ? sides.fronts.facets : sides.backs.facets) {
    out.surface(complemented ? Opcode::linear_lt : Opcode::linear_gt, context.layout.candidate,
                context.linear_of(other.halfspace), block.pixels);
  }
  if (complemented) emit_near_test(context, out, surface);
  return surface;
}

void emit_depth_test(const Context& context, Broadcast& out, const PlannedSurface& planned) {
  for_effects(context, out, &Effect::admit, [&](const Effect& effect, const EffectCall& call) {
    effect.admit(call, out, planned);
    return false;
  });
  out.origin = {isa::Purpose::merge, planned.primitive(), isa::no_node};
  if (context.beyond_plane != nullptr)
    out.surface(Opcode::linear_lt, context.layout.candidate, *context.beyond_plane, planned.block.pixels);
  if (context.beyond.width > 0) out.plain(Opcode::field_lt, context.beyond, context.layout.candidate);
  out.plain(Opcode::field_lt, context.layout.candidate, context.layout.depth);
  out.plain(Opcode::enable_store, context.layout.mask);
}

void emit_merge(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface) {
  const Layout& layout = context.layout;
  out.origin = {isa::Purpose::merge, planned.primitive(), planned.set.size() > 1 ? planned.primitive() : isa::no_node};
  out.plain(Opcode::copy, layout.depth, layout.candidate);
  for_effects(context, out, &Effect::merge, [&](const Effect& effect, const EffectCall& call) {
    effect.merge(call, out, planned);
    return false;
  });
  if (layout.owner.width > 0) {
    out.plain(Opcode::set_constant, layout.owner, {}, planned.number);
  } else if (layout.candidate_colour.width > 0) {
    out.plain(Opcode::copy, layout.colour, layout.candidate_colour);
  } else {
    emit_facet_colours(context, out, planned, surface, layout.candidate, {});
  }
}

}  // namespace csgsim::emit
