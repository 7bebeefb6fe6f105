#include "host/emit/surface.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "host/emit/effect.h"
#include "host/emit/halfspaces.h"
#include "host/emit/near_cap.h"
#include "host/emit/quadric_depths.h"
#include "host/emit/shading.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;

/// Writes the extreme of the facets to Z1: the farthest of the fronts, or the nearest of the backs of a complemented
/// primitive. Starts from depth 0 if the surface may be there, else from a facet that fits Z1, else from the end of the
/// depth range.
class Extreme {
 public:
  /// E is 0 outside `enabled`.
  Extreme(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
          const view::PixelRect& enabled)
      : context_(context),
        out_(out),
        planned_(planned),
        surface_(surface),
        enabled_(enabled),
        farthest_front_(!context.complemented(planned.primitive())),
        first_(first_facet()) {}

  /// Writes depths without colours. Curved facets come last, so that the root of the last one remains.
  void emit() {
    start();
    for (const Facet& facet : surface_.facets) {
      if (&facet == first_ || is_curved(facet.at)) continue;
      out_.surface(farthest_front_ ? Opcode::keep_max : Opcode::keep_min, context_.layout.candidate,
                   context_.linear_plane(facet.halfspace), surface_.block.pixels);
    }
    for (const Facet& facet : surface_.facets) {
      if (&facet == first_ || !is_curved(facet.at)) continue;
      const isa::Field depth = curved_depth(facet);
      out_.plain(Opcode::enable_store, context_.layout.kept);
      replace_by(depth, false);
      out_.plain(Opcode::enable_load, context_.layout.kept);
    }
  }

  /// Writes depths and colours. E is reloaded from the mask for each facet. Of facets at the same depth the first
  /// counts: facets after the start replace only smaller values, in order; facets before the start also replace equal
  /// values, in reverse order.
  void emit_with_colours() {
    const std::vector<Facet>& facets = surface_.facets;
    start();
    out_.plain(Opcode::enable_store, context_.layout.mask);
    set_colour(first_ != nullptr ? *first_ : facets.back());
    const std::size_t after = first_ != nullptr ? static_cast<std::size_t>(first_ - facets.data()) + 1 : facets.size();
    for (std::size_t i = after; i < facets.size(); ++i) replace_by(facets[i], false);
    for (std::size_t i = first_ != nullptr ? after - 1 : after; i-- > 0;) replace_by(facets[i], true);
    out_.plain(Opcode::enable_load, context_.layout.mask);
  }

  /// The curved facet whose root remains; null if none was computed.
  [[nodiscard]] const Facet* rooted() const { return rooted_; }

 private:
  /// The facet that Z1 starts with; null if none fits.
  [[nodiscard]] const Facet* first_facet() const {
    const std::vector<Facet>& facets = surface_.facets;
    const auto find = [&](const auto& is_one) {
      const auto found = std::find_if(facets.begin(), facets.end(), is_one);
      return found == facets.end() ? nullptr : &*found;
    };
    const Facet* first = find([](const Facet& facet) { return facet.at != At::plane && !is_curved(facet.at); });
    if (first == nullptr) {
      first = find([&](const Facet& facet) {
        return facet.at == At::plane && fits_depth(context_, facet, surface_.block, farthest_front_);
      });
    }
    return first != nullptr ? first : find([](const Facet& facet) { return is_curved(facet.at); });
  }

  /// The depth of a curved facet. E stays 1 where the facet exists.
  isa::Field curved_depth(const Facet& facet, isa::Field into = {}) {
    rooted_ = &facet;
    return emit_facet_depth(context_, out_, facet, surface_.block.pixels, enabled_, into);
  }

  /// Z1 := the depth where E stays 1: where it is more extreme, or equal if `equals_too`.
  void replace_by(isa::Field depth, bool equals_too) {
    const isa::Field z1 = context_.layout.candidate;
    const Opcode compare = equals_too ? Opcode::field_le : Opcode::field_lt;
    farthest_front_ ? out_.plain(compare, z1, depth) : out_.plain(compare, depth, z1);
    out_.plain(Opcode::copy, z1, depth);
  }

  void start() {
    const isa::Field z1 = context_.layout.candidate;
    if (first_ != nullptr && is_curved(first_->at)) {
      const isa::Field depth = curved_depth(*first_, z1);
      if (depth != z1) out_.plain(Opcode::copy, z1, depth);
    } else if (first_ != nullptr && first_->at == At::plane) {
      out_.surface(Opcode::load_linear, z1, context_.linear_plane(first_->halfspace), surface_.block.pixels);
    } else {
      out_.plain(Opcode::set_constant, z1, {}, farthest_front_ ? 0 : static_cast<std::uint64_t>(context_.farthest()));
    }
  }

  /// Writes the facet's depth and colour where it is more extreme than Z1, or equal if `equals_too`.
  void replace_by(const Facet& facet, bool equals_too) {
    out_.plain(Opcode::enable_load, context_.layout.mask);
    if (is_curved(facet.at)) {
      const isa::Field depth = curved_depth(facet);
      out_.plain(Opcode::enable_store, context_.layout.mask);
      replace_by(depth, equals_too);
    } else {
      replace_by_plane(facet, equals_too);
    }
    set_colour(facet);
  }

  void replace_by_plane(const Facet& facet, bool equals_too) {
    const view::FixedLinear& plane = context_.linear_plane(facet.halfspace);
    const view::PixelRect& pixels = surface_.block.pixels;
    const view::Range range = context_.depth_range(facet.halfspace, pixels);
    if (farthest_front_ && range.high > context_.farthest()) {
      // There is no surface beyond the farthest depth.
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
  }

  void set_colour(const Facet& facet) {
    const isa::Origin origin = out_.origin;
    out_.origin = facet_origin(isa::Purpose::shade, planned_, facet);
    emit_colour(context_, out_, facet, context_.layout.candidate_colour, surface_.block.pixels);
    out_.origin = origin;
  }

  const Context& context_;
  Broadcast& out_;
  const PlannedSurface& planned_;
  const Surface& surface_;
  const view::PixelRect enabled_;
  bool farthest_front_;
  const Facet* first_;  ///< the facet that Z1 starts with, if any
  const Facet* rooted_ = nullptr;
};

/// A subtracted solid has no back where it ends in front of the near plane.
void emit_near_test(const Context& context, Broadcast& out, const Surface& surface) {
  const bool reaches = std::any_of(surface.facets.begin(), surface.facets.end(), [&](const Facet& back) {
    return is_curved(back.at) ? surface.block.z_low <= 0
                              : context.depth_range(back.halfspace, surface.block.pixels).low <= 0;
  });
  if (reaches) out.surface(Opcode::linear_lt, context.layout.candidate, {0, 0, 0}, surface.block.pixels);
}

/// Whether the surface consists only of this quadric, whose near and far depths always differ.
bool is_own_other_side(const Surface& surface, const QuadricBound& bound) {
  return surface.facets.size() == 1 && is_curved(surface.facets.front().at) &&
         surface.facets.front().quadric == bound.side && bound.role == view::QuadricRole::between;
}

/// Whether the outline test of the only quadric rejects all pixels outside the block, so that no clipping is needed.
bool is_cut_out_by_outline(const Context& context, const PlannedSurface& planned, const Sides& sides,
                           const Surface& surface) {
  if (planned.set.size() != 1 || sides.quadrics.size() != 1) return false;
  return context.geometry.solids[planned.primitive()].halfspaces.empty() &&
         is_own_other_side(surface, sides.quadrics.front()) &&
         is_met_within(context, sides.quadrics.front(), planned.block.pixels, context.plan.pixels());
}

/// Clears E where the other side of a quadric is in front of Z1 or behind it, as there is no surface. The root of the
/// facet `rooted` is already computed, if not null.
void emit_other_sides(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides,
                      const Surface& surface, const Facet* rooted) {
  const bool complemented = context.complemented(planned.primitive());
  const isa::Field z1 = context.layout.candidate;
  const std::vector<QuadricBound> backwards(sides.quadrics.rbegin(), sides.quadrics.rend());
  for (const QuadricBound& bound : backwards) {
    const std::optional<Facet> other = visible_facet(bound, !complemented);
    if (!other || is_own_other_side(surface, bound)) continue;
    const bool is_there =
        rooted != nullptr && rooted->quadric == bound.side && bound.role == view::QuadricRole::between;
    rooted = nullptr;
    if (!is_there) emit_root(context, out, bound, planned.block.pixels, planned.block.pixels);
    const Root root = other->at == At::quadric_near ? Root::near : Root::far;
    const isa::Field depth = emit_depth(context, out, bound, root, planned.block.pixels);
    complemented ? out.plain(Opcode::field_lt, depth, z1) : out.plain(Opcode::field_lt, z1, depth);
  }
}

/// Whether the facet at depth 0 must be among the facets: all curved fronts may be at or before depth 0, and it is none
/// of them.
bool may_be_at_near(const Context& context, const PlannedSurface& planned, const Sides& sides) {
  const auto is_front = [](const QuadricBound& bound) { return visible_facet(bound, false).has_value(); };
  if (std::none_of(sides.quadrics.begin(), sides.quadrics.end(), is_front)) return true;
  return planned.block.z_low <= 0 && !is_curved(near_facet(context, planned.primitive()).at) &&
         std::all_of(sides.quadrics.begin(), sides.quadrics.end(), [&](const QuadricBound& bound) {
           return !is_front(bound) || may_reach_near(context, bound, planned.block.pixels);
         });
}

}  // namespace

bool fits_depth(const Context& context, const Facet& facet, const csg::Block& block, bool is_front) {
  const view::Range range = context.depth_range(facet.halfspace, block.pixels);
  return is_front ? range.low >= 0 : range.high <= context.farthest();
}

isa::Field emit_facet_depth(const Context& context, Broadcast& out, const Facet& facet, const view::PixelRect& pixels,
                            const view::PixelRect& enabled, isa::Field into) {
  const QuadricBound bound{facet.primitive, facet.quadric,
                           view::role_of(context.view.quadrics[facet.quadric.quadric], facet.quadric)};
  emit_root(context, out, bound, pixels, enabled);
  return emit_depth(context, out, bound, facet.at == At::quadric_near ? Root::near : Root::far, pixels, into);
}

Surface plan_surface(const Context& context, const PlannedSurface& planned, const Sides& sides) {
  const csg::Block& block = planned.block;
  const bool complemented = context.complemented(planned.primitive());
  Surface surface{false, complemented ? sides.backs.facets : sides.fronts.facets, block, 0};
  for (const QuadricBound& bound : sides.quadrics)
    if (const std::optional<Facet> facet = visible_facet(bound, complemented)) surface.facets.push_back(*facet);
  // Among facets at the same depth, the first is visible: that of the first primitive.
  std::stable_sort(surface.facets.begin(), surface.facets.end(),
                   [](const Facet& a, const Facet& b) { return a.primitive < b.primitive; });
  surface.nothing =
      sides.nothing || sides.fronts.nothing || sides.backs.nothing || (complemented && surface.facets.empty());
  if (surface.nothing) return surface;
  if (!complemented && may_be_at_near(context, planned, sides) && may_reach_near(context, sides.fronts.facets, block))
    surface.facets.insert(surface.facets.begin(), near_facet(context, planned.primitive()));
  return surface;
}

Surface emit_surface(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const csg::Block& block = planned.block;
  const bool complemented = context.complemented(planned.primitive());
  Surface surface = plan_surface(context, planned, sides);
  if (surface.nothing) return surface;
  out.origin = {isa::Purpose::render, planned.primitive(), isa::no_node};
  enable_drawing(context, out);
  const bool is_cut_out = is_cut_out_by_outline(context, planned, sides, surface);
  if (!is_cut_out) out.clip(block.pixels, context.plan.pixels());
  surface.begin = out.size();
  for (const std::uint32_t primitive : planned.set) emit_edges(context, out, primitive, sides.column);
  Extreme extreme(context, out, planned, surface, is_cut_out ? context.plan.pixels() : block.pixels);
  context.layout.candidate_colour.width > 0 ? extreme.emit_with_colours() : extreme.emit();
  for (const Facet& other : complemented ? sides.fronts.facets : sides.backs.facets) {
    out.surface(complemented ? Opcode::linear_lt : Opcode::linear_gt, context.layout.candidate,
                context.linear_plane(other.halfspace), block.pixels);
  }
  emit_other_sides(context, out, planned, sides, surface, extreme.rooted());
  if (complemented) emit_near_test(context, out, surface);
  out.counts.rendered += planned.set.size();
  return surface;
}

void emit_admission(const Context& context, Broadcast& out, const PlannedSurface& planned) {
  for_effects(context, out, &Effect::admit, planned);
  out.origin = {isa::Purpose::merge, planned.primitive(), isa::no_node};
  if (context.beyond_plane != nullptr)
    out.surface(Opcode::linear_lt, context.layout.candidate, *context.beyond_plane, planned.block.pixels);
  if (context.beyond.width > 0) out.plain(Opcode::field_lt, context.beyond, context.layout.candidate);
}

void emit_depth_test(const Context& context, Broadcast& out, const PlannedSurface& planned) {
  out.origin = {isa::Purpose::merge, planned.primitive(), isa::no_node};
  out.plain(Opcode::field_lt, context.layout.candidate, context.layout.depth);
  out.plain(Opcode::enable_store, context.layout.mask);
}

void emit_merge(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface) {
  const Layout& layout = context.layout;
  out.origin = {isa::Purpose::merge, planned.primitive(), planned.set.size() > 1 ? planned.primitive() : isa::no_node};
  out.plain(Opcode::copy, layout.depth, layout.candidate);
  for_effects(context, out, &Effect::merge, planned);
  if (layout.owner.width > 0) {
    out.plain(Opcode::set_constant, layout.owner, {}, planned.number);
  } else if (layout.candidate_colour.width > 0) {
    out.plain(Opcode::copy, layout.colour, layout.candidate_colour);
  } else {
    emit_facet_colours(context, out, planned, surface, layout.candidate, {});
  }
}

}  // namespace csgsim::emit
