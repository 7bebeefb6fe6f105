#include "host/emit/surface.h"

#include <algorithm>

#include "host/emit/facet_colour.h"
#include "host/emit/halfspaces.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;
using view::Side;

/// Whether the facet fits Z1 wherever it is, before the other bound of the depth range too.
bool fits(const Context& context, facet::Halfspace facet, const csg::Block& block, bool farthest_front) {
  const view::Range range = context.range_of(facet, block.pixels);
  return farthest_front ? range.low >= 0 : range.high <= context.farthest();
}

/// The extreme of the facets into Z1: the farthest of the fronts, or the nearest of the backs of a complemented
/// primitive. Starts from a facet that fits Z1 where there is one, else from the bound of the depth range.
class Extreme {
 public:
  Extreme(const Context& context, Broadcast& out, std::uint32_t primitive, const Surface& surface)
      : context_(context),
        out_(out),
        colour_(context, primitive),
        surface_(surface),
        farthest_front_(!context.complemented(primitive)),
        first_(std::find_if(surface.facets.begin(), surface.facets.end(), [&](const facet::Halfspace& facet) {
          return !surface.near_cap && fits(context, facet, surface.block, farthest_front_);
        })) {}

  /// Without colours.
  void emit() {
    start();
    for (auto facet = surface_.facets.begin(); facet != surface_.facets.end(); ++facet) {
      if (facet == first_) continue;
      out_.surface(farthest_front_ ? Opcode::keep_max : Opcode::keep_min, context_.layout.candidate,
                   context_.linear_of(*facet), surface_.block.pixels);
    }
  }

  /// With colours beside: E is taken from the mask anew for each facet. Of facets at the same depth the first counts,
  /// and the cap before all of them: what stands after the start replaces less than it, in order; what stands before
  /// the start replaces equals too, backwards.
  void emit_with_colours() {
    const auto begin = surface_.facets.begin();
    const auto end = surface_.facets.end();
    const bool from_facet = first_ != end;
    const auto before = from_facet ? first_ : (surface_.near_cap ? begin : end);
    start();
    out_.plain(Opcode::enable_store, context_.layout.mask);
    set_colour(from_facet ? colour_.of(*first_) : (surface_.near_cap ? colour_.of_cap() : colour_.of(*(end - 1))));
    for (auto facet = from_facet ? before + 1 : before; facet != end; ++facet) replace_by(*facet, false);
    for (auto facet = before; facet != begin;) replace_by(*--facet, true);
    out_.plain(Opcode::enable_load, context_.layout.mask);
  }

 private:
  void start() {
    const isa::Field z1 = context_.layout.candidate;
    if (first_ != surface_.facets.end()) {
      out_.surface(Opcode::load_linear, z1, context_.linear_of(*first_), surface_.block.pixels);
    } else {
      out_.plain(Opcode::set_constant, z1, {}, farthest_front_ ? 0 : static_cast<std::uint64_t>(context_.farthest()));
    }
  }

  /// The facet's depth and colour where it is more extreme than Z1, or equal.
  void replace_by(facet::Halfspace facet, bool equals_too) {
    const view::FixedLinear& plane = context_.linear_of(facet);
    const view::PixelRect& pixels = surface_.block.pixels;
    out_.plain(Opcode::enable_load, context_.layout.mask);
    const view::Range range = context_.range_of(facet, pixels);
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
    set_colour(colour_.of(facet));
  }

  void set_colour(std::uint32_t colour) {
    const isa::Origin origin = out_.origin;
    out_.origin.purpose = isa::Purpose::shade;
    out_.plain(Opcode::set_constant, context_.layout.candidate_colour, {}, colour);
    out_.origin = origin;
  }

  const Context& context_;
  Broadcast& out_;
  FacetColour colour_;
  const Surface& surface_;
  bool farthest_front_;
  std::vector<facet::Halfspace>::const_iterator first_;
};

/// A subtracted solid has no back where it ends before the near plane.
void emit_near_test(const Context& context, Broadcast& out, const Surface& surface) {
  const bool reaches = std::any_of(surface.facets.begin(), surface.facets.end(), [&](const facet::Halfspace& back) {
    return context.range_of(back, surface.block.pixels).low <= 0;
  });
  if (reaches) out.surface(Opcode::linear_lt, context.layout.candidate, {0, 0, 0}, surface.block.pixels);
}

/// Whether the near plane may be what is seen of a primitive: Z1 is 0 there.
bool may_be_cut(const Context& context, std::uint32_t primitive, const Surface& surface) {
  if (surface.facets.empty()) return true;
  return context.view.extents[primitive].cut_by_near &&
         std::none_of(surface.facets.begin(), surface.facets.end(), [&](const facet::Halfspace& front) {
           return context.range_of(front, surface.block.pixels).low > 0;
         });
}

/// Finds where each facet is seen by broadcasting it again, the mask holding what is left.
void emit_colours(const Context& context, Broadcast& out, std::uint32_t primitive, const Surface& surface) {
  const Layout& layout = context.layout;
  const FacetColour colours(context, primitive);
  bool first = true;
  // E stays where the plane is; `rest` is what no plane before was.
  const auto colour_where = [&](const view::FixedLinear& plane, bool rest, std::uint32_t colour) {
    if (!first) out.plain(Opcode::enable_load, layout.mask);
    first = false;
    if (!rest) out.surface(Opcode::linear_eq, layout.candidate, plane, surface.block.pixels);
    out.plain(Opcode::set_constant, layout.colour, {}, colour);
    if (!rest) out.plain(Opcode::set_constant, layout.mask, {}, 0);
  };
  if (surface.near_cap) colour_where({0, 0, 0}, surface.facets.empty(), colours.of_cap());
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    colour_where(context.linear_of(surface.facets[i]), i + 1 == surface.facets.size(), colours.of(surface.facets[i]));
  }
}

}  // namespace

Surface emit_surface(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block) {
  const bool complemented = context.complemented(primitive);
  // Half-spaces decide over the whole depth range: Z1 is not known yet.
  const csg::Block column{block.pixels, 0, context.farthest()};
  const Deciding fronts = deciding(context, primitive, Side::front, column);
  const Deciding backs = deciding(context, primitive, Side::back, column);

  Surface surface{false, false, complemented ? backs.halfspaces : fronts.halfspaces, block};
  surface.nothing = fronts.nothing || backs.nothing || (complemented && surface.facets.empty());
  if (surface.nothing) return surface;
  surface.near_cap = !complemented && may_be_cut(context, primitive, surface);

  out.origin = {isa::Purpose::render, primitive, isa::no_node};
  out.plain(Opcode::enable_all);
  out.clip(block.pixels, context.screen());
  emit_edges(context, out, primitive, column);
  Extreme extreme(context, out, primitive, surface);
  context.layout.candidate_colour.width > 0 ? extreme.emit_with_colours() : extreme.emit();
  const std::vector<facet::Halfspace>& others = complemented ? fronts.halfspaces : backs.halfspaces;
  for (const facet::Halfspace& other : others) {
    out.surface(complemented ? Opcode::linear_lt : Opcode::linear_gt, context.layout.candidate,
                context.linear_of(other), block.pixels);
  }
  if (complemented) emit_near_test(context, out, surface);
  return surface;
}

void emit_depth_test(const Context& context, Broadcast& out, std::uint32_t primitive) {
  out.origin = {isa::Purpose::merge, primitive, isa::no_node};
  out.plain(Opcode::field_lt, context.layout.candidate, context.layout.depth);
  out.plain(Opcode::enable_store, context.layout.mask);
}

void emit_merge(const Context& context, Broadcast& out, std::uint32_t primitive, const Surface& surface) {
  const Layout& layout = context.layout;
  out.origin = {isa::Purpose::merge, primitive, isa::no_node};
  out.plain(Opcode::copy, layout.depth, layout.candidate);
  if (layout.candidate_colour.width > 0) {
    out.plain(Opcode::copy, layout.colour, layout.candidate_colour);
    return;
  }
  out.origin.purpose = isa::Purpose::shade;
  emit_colours(context, out, primitive, surface);
}

}  // namespace csgsim::emit
