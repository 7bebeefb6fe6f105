#include "host/emit/stored.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "host/emit/drawing.h"
#include "host/emit/early_out.h"
#include "host/emit/halfspaces.h"
#include "host/emit/levels.h"
#include "host/emit/quadric_depths.h"
#include "host/emit/strategy.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;
using view::QuadricRole;
using view::Side;

/// The primitive's pixels within the segment.
view::PixelRect primitive_pixels(const Context& context, std::uint32_t primitive) {
  return common(context.view.extents[primitive].pixels, context.plan.pixels());
}

bool has_pixels_in_common(const PlannedSurface& surface, std::uint32_t primitive, const view::View& view) {
  return !common(surface.block.pixels, view.extents[primitive].pixels).empty();
}

void add_compared(const PlannedSurface& surface, const view::View& view, std::vector<std::uint32_t>& all) {
  const auto add = [&](std::uint32_t primitive) {
    if (has_pixels_in_common(surface, primitive, view)) all.push_back(primitive);
  };
  for (const csg::ActiveNode& node : surface.active.nodes) {
    if (!node.is_leaf) continue;
    add(node.primitive);
    for (const std::uint32_t other : node.others) add(other);
  }
}

void sort_unique(std::vector<std::uint32_t>& all) {
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

/// Writes one end of a primitive to its field: the farthest of the fronts, or the nearest of the backs.
class End {
 public:
  End(const Context& context, Broadcast& out, const csg::Block& column, Side side, isa::Field field)
      : context_(context), out_(out), column_(column), is_front_(side == Side::front), field_(field) {}

  /// E stays 1 where the extreme of the planes is a depth, or before the first one for a front, or behind the last one
  /// for a back.
  void begin(const std::vector<Facet>& facets, bool quadrics_follow) {
    const auto first = std::ranges::find_if(
        facets, [&](const Facet& facet) { return fits_depth(context_, facet, column_, is_front_); });
    is_set_ = !facets.empty() || !quadrics_follow;
    if (!is_set_) return;
    if (first != facets.end()) {
      out_.surface(Opcode::load_linear, field_, context_.linear_plane(first->halfspace), column_.pixels);
    } else {
      out_.constant(field_, is_front_ ? 0 : static_cast<std::uint64_t>(context_.farthest()));
    }
    for (auto facet = facets.begin(); facet != facets.end(); ++facet) {
      if (facet == first) continue;
      out_.surface(is_front_ ? Opcode::keep_max : Opcode::keep_min, field_, context_.linear_plane(facet->halfspace),
                   column_.pixels);
    }
  }

  /// Combines the field with the depth of a quadric, where E is 1.
  void add(isa::Field depth) {
    if (!is_set_) {
      out_.plain(Opcode::copy, field_, depth);
      is_set_ = true;
      return;
    }
    out_.plain(Opcode::enable_store, context_.layout.kept);
    is_front_ ? out_.plain(Opcode::field_lt, field_, depth) : out_.plain(Opcode::field_lt, depth, field_);
    out_.plain(Opcode::copy, field_, depth);
    out_.plain(Opcode::enable_load, context_.layout.kept);
  }

 private:
  const Context& context_;
  Broadcast& out_;
  const csg::Block& column_;
  bool is_front_;
  isa::Field field_;
  bool is_set_ = false;
};

bool has_front(QuadricRole role) { return role == QuadricRole::between || role == QuadricRole::from; }
bool has_back(QuadricRole role) { return role == QuadricRole::between || role == QuadricRole::until; }

/// The quadrics that bound the column and are not edge tests.
std::vector<QuadricBound> bounds_in(const Context& context, std::uint32_t primitive, const csg::Block& column) {
  std::vector<QuadricBound> bounds = quadric_bounds(context, primitive);
  std::erase_if(bounds, [&](const QuadricBound& bound) {
    return bound.role == QuadricRole::edge || locate_block(context, bound, column) == csg::Containment::in;
  });
  return bounds;
}

void emit_depths(const Context& context, Broadcast& out, std::uint32_t primitive, const StoredFields& fields) {
  out.origin = {isa::Purpose::classify, primitive, isa::no_node};
  const csg::Block column{primitive_pixels(context, primitive), 0, context.farthest()};
  enable_drawing(context, out);
  out.clip(column.pixels, context.plan.pixels());
  const std::size_t begin = out.size();
  emit_edges(context, out, primitive, column);
  const std::vector<QuadricBound> bounds = bounds_in(context, primitive, column);
  const auto any = [&](bool (*has)(QuadricRole)) {
    return std::ranges::any_of(bounds, [&](const QuadricBound& bound) { return has(bound.role); });
  };
  End front(context, out, column, Side::front, fields.front);
  End back(context, out, column, Side::back, fields.back);
  front.begin(deciding_facets(context, {&primitive, 1}, Side::front, column).facets, any(has_front));
  back.begin(deciding_facets(context, {&primitive, 1}, Side::back, column).facets, any(has_back));
  for (const QuadricBound& bound : bounds) {
    emit_root(context, out, bound, column.pixels, column.pixels);
    if (bound.role != QuadricRole::from) {
      const isa::Field near = emit_depth(context, out, bound, Root::near, column.pixels);
      has_front(bound.role) ? front.add(near) : back.add(near);
    }
    if (bound.role != QuadricRole::until) {
      const isa::Field far = emit_depth(context, out, bound, Root::far, column.pixels);
      has_back(bound.role) ? back.add(far) : front.add(far);
    }
  }
  // A drawing that is restricted to some pixels may contain none of the primitive's.
  if (context.base.width > 0) emit_early_out(context, out, begin, out.origin);
  // Marks the pixels outside the primitive as empty.
  out.plain(Opcode::enable_invert);
  out.constant(fields.front, static_cast<std::uint64_t>(context.farthest()));
  out.constant(fields.back, 0);
  ++out.counts.rendered;
}

/// The parts of a primitive that decide whether points of a block are in it.
struct DecidingParts {
  bool front = false;
  bool back = false;
  bool outline = false;  ///< the primitive is absent at some of the pixels
};

DecidingParts deciding_parts(const Context& context, std::uint32_t primitive, const csg::Block& part) {
  const auto any = [&](Side side) { return !cutting_facets(context, {&primitive, 1}, side, part).facets.empty(); };
  DecidingParts decides{any(Side::front), any(Side::back), has_edges(context, primitive, part)};
  for (const QuadricBound& bound : quadric_bounds(context, primitive)) {
    if (bound.role == QuadricRole::edge) continue;
    const bool is_out = locate_block(context, bound, part) == csg::Containment::out;
    const RelevantParts matters = relevant_parts(context, bound, part);
    const bool is_front = has_front(bound.role);
    const bool is_back = has_back(bound.role);
    decides.front = decides.front || (is_front && (is_out || (is_back ? matters.near : matters.far)));
    decides.back = decides.back || (is_back && (is_out || (is_front ? matters.far : matters.near)));
    decides.outline = decides.outline || matters.outline;
  }
  return decides;
}

}  // namespace

StoredDepths::StoredDepths(const Context& context) : layout_(context.layout) {
  if (layout_.stored.empty()) return;
  for (const PlannedSurface& one : context.plan.surfaces)
    if (is_drawn(context, one)) add_compared(one, context.view, primitives_);
  sort_unique(primitives_);
}

std::optional<StoredFields> StoredDepths::of(std::uint32_t primitive) const {
  const auto found = std::ranges::lower_bound(primitives_, primitive);
  if (found == primitives_.end() || *found != primitive) return std::nullopt;
  const auto place = 2 * static_cast<std::size_t>(found - primitives_.begin());
  return StoredFields{layout_.stored.at(place), layout_.stored.at(place + 1)};
}

void emit_stored_depths(const Context& context, Broadcast& out) {
  if (context.stored == nullptr) return;
  for (const std::uint32_t primitive : context.stored->primitives())
    emit_depths(context, out, primitive, *context.stored->of(primitive));
}

void emit_stored_comparison(const Context& context, Broadcast& out, std::uint32_t primitive, const StoredFields& fields,
                            const PlannedSurface& surface) {
  const view::PixelRect shared = common(surface.block.pixels, context.view.extents[primitive].pixels);
  const DecidingParts decides = deciding_parts(context, primitive, {shared, surface.block.z_low, surface.block.z_high});
  const bool is_nowhere_at_some = decides.outline || shared != surface.block.pixels;
  const isa::Field z1 = context.layout.candidate;
  if (decides.front) out.plain(Opcode::field_le, fields.front, z1);
  // Either comparison fails at pixels without the primitive.
  if (decides.back || (!decides.front && is_nowhere_at_some)) out.plain(Opcode::field_lt, z1, fields.back);
}

namespace {

/// Whether the depths of every part of the surface are stored, and there is no colour field for Z1.
bool has_stored_surface(const Context& context, const PlannedSurface& planned) {
  if (context.stored == nullptr || context.layout.candidate_colour.width > 0) return false;
  return std::ranges::all_of(planned.set,
                             [&](std::uint32_t primitive) { return context.stored->of(primitive).has_value(); });
}

/// Draws a surface as emit_surface does, from stored depths.
Surface emit_stored_surface(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  Surface surface = plan_surface(context, planned, sides);
  if (surface.nothing) return surface;
  out.origin = {isa::Purpose::render, planned.primitive(), isa::no_node};
  enable_drawing(context, out);
  const StoredFields first = *context.stored->of(planned.primitive());
  // The primitive is absent outside its own pixels.
  out.plain(Opcode::field_lt, first.front, first.back);
  out.clip(planned.block.pixels, primitive_pixels(context, planned.primitive()));
  surface.begin = out.size();
  const bool complemented = context.complemented(planned.primitive());
  const isa::Field z1 = context.layout.candidate;
  out.plain(Opcode::copy, z1, complemented ? first.back : first.front);
  if (planned.set.size() == 1) return surface;
  for (const std::uint32_t primitive : std::span(planned.set).subspan(1)) {
    const StoredFields other = *context.stored->of(primitive);
    out.plain(Opcode::enable_store, context.layout.mask);
    complemented ? out.plain(Opcode::field_lt, other.back, z1) : out.plain(Opcode::field_lt, z1, other.front);
    out.plain(Opcode::copy, z1, complemented ? other.back : other.front);
    out.plain(Opcode::enable_load, context.layout.mask);
  }
  for (const std::uint32_t primitive : planned.set) {
    const StoredFields one = *context.stored->of(primitive);
    complemented ? out.plain(Opcode::field_lt, one.front, z1) : out.plain(Opcode::field_lt, z1, one.back);
  }
  return surface;
}

Surface emit_surface_by_stored(const Context& context, Broadcast& out, const PlannedSurface& planned,
                               const Sides& sides) {
  return has_stored_surface(context, planned) ? emit_stored_surface(context, out, planned, sides)
                                              : emit_surface(context, out, planned, sides);
}

/// Bits of a front and a back depth for each primitive that a surface of the segment is compared with.
unsigned depth_bits(const SegmentPlan& segment, const view::View& view) {
  std::vector<std::uint32_t> compared;
  for (const PlannedSurface& one : segment.surfaces) add_compared(one, view, compared);
  sort_unique(compared);
  return static_cast<unsigned>(compared.size()) * 2 * view.sampling.z_bits;
}

}  // namespace

/// Thesis 6.1: like `stack`, but the compared primitives are rendered once each and their depths kept.
extern const StrategyRow stored_strategy{.bits = bits_for_all_levels,
                                         .classify = emit_by_all_levels,
                                         .surface = emit_surface_by_stored,
                                         .stored_bits = depth_bits};

}  // namespace csgsim::emit
