#include "host/emit/quadric_depths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "host/emit/curved_light.h"
#include "host/emit/fast_spheres.h"
#include "host/emit/fields.h"
#include "hw/base/error.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using csg::Containment;
using isa::Opcode;
using view::QuadricRole;
using view::RootRanges;

const view::ScreenQuadric& screen(const Context& context, const QuadricBound& bound) {
  return context.view.quadrics[bound.side.quadric];
}

RootRanges root_ranges(const Context& context, const QuadricBound& bound, const view::PixelRect& pixels) {
  return view::ranges_over(screen(context, bound), context.view.sampling.fraction_bits, pixels);
}

bool is_paraboloid(const view::ScreenQuadric& quadric) { return quadric.kind == view::ScreenQuadricKind::paraboloid; }

/// Bits of the root over the pixels.
unsigned root_bits(const RootRanges& ranges) {
  return std::max(1U, static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(ranges.max_root))));
}

bool is_depth(const view::Range& range, std::int64_t farthest) { return range.low >= 0 && range.high <= farthest; }

/// Bits of a sum with these values: those of a depth if all values are depths, else those of a two's complement number.
unsigned sum_bits(const view::Range& range, unsigned z_bits) {
  if (is_depth(range, (std::int64_t{1} << z_bits) - 1)) return z_bits;
  return std::max(z_bits + 1, signed_width(range));
}

/// Clamps a two's complement number to the depth range [0, farthest]. E is preserved.
void emit_clamp(const Context& context, Broadcast& out, isa::Field sum, const view::Range& range) {
  const std::int64_t farthest = context.farthest();
  const isa::Field depth = subfield(sum, 0, context.layout.candidate.width);
  const isa::Field sign = subfield(sum, sum.width - 1U, 1);
  if (is_depth(range, farthest)) return;
  out.plain(Opcode::enable_store, context.layout.kept);
  if (range.low < 0) {
    out.plain(Opcode::enable_and, sign);
    out.constant(depth, 0);
    out.plain(Opcode::enable_load, context.layout.kept);
  }
  if (range.high <= farthest) return;
  // The OR of the bits between the depth's bits and the sign.
  const isa::Field beyond = subfield(sum, depth.width, 1);
  for (unsigned bit = depth.width + 1U; bit + 1U < sum.width; ++bit)
    out.append_bitwise(Opcode::bit_or, beyond, beyond, subfield(sum, bit, 1));
  out.plain(Opcode::enable_and, beyond);
  if (range.low < 0) out.plain(Opcode::enable_and_not, sign);
  out.constant(depth, static_cast<std::uint64_t>(farthest));
  out.plain(Opcode::enable_load, context.layout.kept);
}

bool may_miss(const QuadricBound& bound, const RootRanges& ranges) {
  return bound.role == QuadricRole::until && ranges.discriminant.low < 0;
}

/// Whether every surface of the picture is that of a single primitive that is not compared with others, not subtracted,
/// and satisfies `fits`.
template <class Fits>
bool draws_alone(const Plan& plan, const Fits& fits) {
  const auto is_alone = [&](const PlannedSurface& one) {
    return one.set.size() == 1 && one.active.operands.empty() &&
           !plan.positive.nodes[plan.positive.leaf_of[one.primitive()]].complemented && fits(one.primitive());
  };
  return std::all_of(plan.segments.begin(), plan.segments.end(), [&](const SegmentPlan& segment) {
    return std::all_of(segment.surfaces.begin(), segment.surfaces.end(), is_alone);
  });
}

RelevantParts parts_for(QuadricRole role) {
  return {role != QuadricRole::until, role == QuadricRole::between || role == QuadricRole::until,
          role == QuadricRole::between || role == QuadricRole::from};
}

/// Whether no point of the block is within the bound.
bool is_outside(const QuadricBound& bound, const RootRanges& ranges, const csg::Block& block) {
  const bool never_met = ranges.discriminant.high < 0;
  switch (bound.role) {
    case QuadricRole::edge: return never_met;
    case QuadricRole::between: return never_met || ranges.near.low > block.z_high || ranges.far.high <= block.z_low;
    case QuadricRole::until: return ranges.discriminant.low >= 0 && ranges.near.high <= block.z_low;
    case QuadricRole::from: return never_met || ranges.far.low > block.z_high;
  }
  return false;
}

void refuse_unfit(const Context& context, std::uint32_t primitive) {
  throw InputError(fmt::format(
      "{}: the depths of this primitive's surface exceed the machine's number range, because the camera looks along a "
      "straight line in the surface or from a point on it; move the camera, or draw facets with --curves auto",
      model::location_text(context.tree, primitive)));
}

}  // namespace

std::vector<QuadricBound> quadric_bounds(const Context& context, std::uint32_t primitive) {
  std::vector<QuadricBound> bounds;
  for (const facet::QuadricSide& side : context.geometry.solids[primitive].quadrics) {
    const view::ScreenQuadric& quadric = context.view.quadrics[side.quadric];
    if (quadric.kind == view::ScreenQuadricKind::unfit) refuse_unfit(context, primitive);
    bounds.push_back({primitive, side, view::role_of(quadric, side)});
  }
  return bounds;
}

RelevantParts relevant_parts(const Context& context, const QuadricBound& bound, const csg::Block& block) {
  RelevantParts matters = parts_for(bound.role);
  if (!context.options.pruning.halfspaces) return matters;
  const RootRanges ranges = root_ranges(context, bound, block.pixels);
  const bool ends_at_near = bound.role == QuadricRole::until;
  if (ends_at_near && ranges.discriminant.high < 0) return {false, false, false};
  matters.outline = matters.outline && ranges.discriminant.low < 0;
  matters.near = matters.near && !(ends_at_near ? ranges.near.low > block.z_high : ranges.near.high <= block.z_low);
  matters.far = matters.far &&
                !(bound.role == QuadricRole::from ? ranges.far.high <= block.z_low : ranges.far.low > block.z_high);
  return matters;
}

Containment locate_block(const Context& context, const QuadricBound& bound, const csg::Block& block) {
  context.counted.add(&isa::Preparation::halfspaces, csg::tests_of_quadric);
  if (!context.options.pruning.halfspaces) return Containment::depends;
  const RootRanges ranges = root_ranges(context, bound, block.pixels);
  if (is_outside(bound, ranges, block)) return Containment::out;
  if (bound.role == QuadricRole::edge) return ranges.discriminant.low >= 0 ? Containment::in : Containment::depends;
  const RelevantParts matters = relevant_parts(context, bound, block);
  return matters.outline || matters.near || matters.far ? Containment::depends : Containment::in;
}

bool may_reach_near(const Context& context, const QuadricBound& bound, const view::PixelRect& pixels) {
  const RootRanges ranges = root_ranges(context, bound, pixels);
  return ranges.discriminant.high >= 0 && (bound.role == QuadricRole::from ? ranges.far : ranges.near).low <= 0;
}

QuadricBits quadric_bits(const facet::Geometry& geometry, const view::View& view, unsigned colour_bits) {
  QuadricBits bits;
  for (std::size_t primitive = 0; primitive < geometry.solids.size(); ++primitive) {
    const view::PixelRect& pixels = view.extents[primitive].pixels;
    for (const facet::QuadricSide& side : geometry.solids[primitive].quadrics) {
      const view::ScreenQuadric& quadric = view.quadrics[side.quadric];
      if ((quadric.kind != view::ScreenQuadricKind::roots && !is_paraboloid(quadric)) || pixels.empty()) continue;
      const RootRanges ranges = view::ranges_over(quadric, view.sampling.fraction_bits, pixels);
      const unsigned root = is_paraboloid(quadric) ? 0 : root_bits(ranges);
      const unsigned sum = quadric.factor.fraction() + std::max(sum_bits(ranges.near, view.sampling.z_bits),
                                                                sum_bits(ranges.far, view.sampling.z_bits));
      bits.root = std::max(bits.root, root);
      bits.sum = std::max({bits.sum, sum, root + 1, light_bits(colour_bits)});
    }
  }
  return bits;
}

bool draws_in_place(const facet::Geometry& geometry, const view::View& view, const Plan& plan, unsigned colour_bits) {
  const unsigned z_bits = view.sampling.z_bits;
  const auto fits = [&](std::uint32_t primitive) {
    const view::PixelRect& pixels = view.extents[primitive].pixels;
    return std::all_of(geometry.solids[primitive].quadrics.begin(), geometry.solids[primitive].quadrics.end(),
                       [&](const facet::QuadricSide& side) {
                         const view::ScreenQuadric& quadric = view.quadrics[side.quadric];
                         if (!is_paraboloid(quadric) || quadric.factor.fraction() > 0) return false;
                         const RootRanges ranges = view::ranges_over(quadric, view.sampling.fraction_bits, pixels);
                         return sum_bits(ranges.near, z_bits) == z_bits;
                       });
  };
  return geometry.fast_spheres && light_bits(colour_bits) <= z_bits && draws_alone(plan, fits);
}

bool takes_roots_in_candidate(const facet::Geometry& geometry, const view::View& view, const Plan& plan) {
  const unsigned z_bits = view.sampling.z_bits;
  return draws_alone(plan, [&](std::uint32_t primitive) {
    const facet::Convex& solid = geometry.solids[primitive];
    if (solid.quadrics.empty()) return true;
    const view::ScreenQuadric& quadric = view.quadrics[solid.quadrics.front().quadric];
    const bool is_ellipsoid = solid.quadrics.size() == 1 && solid.halfspaces.empty() &&
                              quadric.kind == view::ScreenQuadricKind::roots &&
                              view::role_of(quadric, solid.quadrics.front()) == QuadricRole::between;
    if (!is_ellipsoid || quadric.unit > 0) return false;
    const RootRanges ranges = view::ranges_over(quadric, view.sampling.fraction_bits, view.extents[primitive].pixels);
    return root_bits(ranges) <= z_bits && ranges.near.low > 0 && sum_bits(ranges.near, z_bits) == z_bits;
  });
}

void emit_outline(const Context& context, Broadcast& out, const QuadricBound& bound, const view::PixelRect& pixels) {
  const view::ScreenQuadric& quadric = screen(context, bound);
  if (is_paraboloid(quadric)) {
    emit_circle(context, out, quadric, pixels);
  } else {
    out.quadratic(Opcode::edge_not_negative, {}, quadric.discriminant, 0, pixels);
  }
}

bool is_met_within(const Context& context, const QuadricBound& bound, const view::PixelRect& pixels,
                   const view::PixelRect& enclosing) {
  const std::array<view::PixelRect, 4> around{{{enclosing.x0, enclosing.y0, enclosing.x1, pixels.y0 - 1},
                                               {enclosing.x0, pixels.y1 + 1, enclosing.x1, enclosing.y1},
                                               {enclosing.x0, pixels.y0, pixels.x0 - 1, pixels.y1},
                                               {pixels.x1 + 1, pixels.y0, enclosing.x1, pixels.y1}}};
  return std::all_of(around.begin(), around.end(), [&](const view::PixelRect& strip) {
    return strip.empty() || root_ranges(context, bound, strip).discriminant.high < 0;
  });
}

void emit_root(const Context& context, Broadcast& out, const QuadricBound& bound, const view::PixelRect& pixels,
               const view::PixelRect& enabled) {
  const view::ScreenQuadric& quadric = screen(context, bound);
  if (is_paraboloid(quadric)) {
    emit_circle(context, out, quadric, enabled);
    return;
  }
  const RootRanges ranges = root_ranges(context, bound, pixels);
  const unsigned bits = root_bits(ranges);
  const isa::Field& root = context.layout.root;
  const isa::Field field{static_cast<std::uint16_t>(root.base - bits - 1), static_cast<std::uint16_t>(2 * bits + 1)};
  if (may_miss(bound, ranges)) out.plain(Opcode::enable_store, context.layout.kept);
  out.quadratic(Opcode::load_linear, field, quadric.discriminant, quadric.discriminant_shift, enabled);
  out.plain(Opcode::root, field);
}

isa::Field emit_depth(const Context& context, Broadcast& out, const QuadricBound& bound, Root root,
                      const view::PixelRect& pixels, isa::Field into) {
  const view::ScreenQuadric& quadric = screen(context, bound);
  const RootRanges ranges = root_ranges(context, bound, pixels);
  const unsigned z_bits = context.layout.candidate.width;
  const bool is_near = root == Root::near;
  const view::Range& range = is_near ? ranges.near : ranges.far;
  const unsigned fraction = quadric.factor.fraction();
  const unsigned bits = fraction + sum_bits(range, z_bits);
  const isa::Field all = into.width == bits && fraction == 0 ? into : subfield(context.layout.sum, 0, bits);
  const isa::Field sum = subfield(all, fraction, bits - fraction);
  const isa::Field depth = subfield(sum, 0, z_bits);
  if (is_paraboloid(quadric)) {
    emit_paraboloid(context, out, quadric, is_near, all, pixels);
  } else {
    out.shifted(subfield(context.layout.root, 0, root_bits(ranges)), sum, quadric.unit);
    view::FixedLinear middle = quadric.middle;
    if (!is_near) middle.c += std::int64_t{1} << (context.view.sampling.fraction_bits + quadric.unit);
    out.surface(is_near ? Opcode::linear_minus : Opcode::linear_plus, sum, middle, pixels);
  }
  if (may_miss(bound, ranges)) {
    // Rays that miss the quadric are inside at every depth.
    out.plain(Opcode::enable_xor, context.layout.kept);
    out.constant(sum, static_cast<std::uint64_t>(context.farthest()));
    out.plain(Opcode::enable_load, context.layout.kept);
  }
  emit_clamp(context, out, sum, range);
  return depth;
}

void emit_comparison(const Context& context, Broadcast& out, const QuadricBound& bound, const csg::Block& block) {
  if (bound.role == QuadricRole::edge) return;  // handled by emit_edges
  if (locate_block(context, bound, block) == Containment::out) {
    out.disable_all();
    return;
  }
  const RelevantParts matters = relevant_parts(context, bound, block);
  if (!matters.near && !matters.far) {
    if (matters.outline) emit_outline(context, out, bound, block.pixels);
    return;
  }
  const isa::Field z1 = context.layout.candidate;
  emit_root(context, out, bound, block.pixels, block.pixels);
  if (matters.near) {
    const isa::Field near = emit_depth(context, out, bound, Root::near, block.pixels);
    if (bound.role == QuadricRole::until)
      out.plain(Opcode::field_lt, z1, near);
    else
      out.plain(Opcode::field_le, near, z1);
  }
  if (matters.far) {
    const isa::Field far = emit_depth(context, out, bound, Root::far, block.pixels);
    if (bound.role == QuadricRole::from)
      out.plain(Opcode::field_le, far, z1);
    else
      out.plain(Opcode::field_lt, z1, far);
  }
}

}  // namespace csgsim::emit
