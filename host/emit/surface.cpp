#include <algorithm>
#include <glm/geometric.hpp>
#include <string>

#include "host/emit/context.h"
#include "hw/isa/error.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;
using view::Side;

/// The half-spaces of a primitive on one side that decide anything in a block.
struct Deciding {
  std::vector<facet::Halfspace> halfspaces;
  bool nothing = false;  ///< one of them holds nothing of the block
};

Deciding deciding(const Context& context, std::uint32_t primitive, Side side, const csg::Block& block) {
  Deciding result;
  for (const facet::Halfspace& halfspace : context.scene.solids[primitive].halfspaces) {
    if (view::side_of(context.view.planes[halfspace.plane], halfspace) != side) continue;
    const csg::Known known = csg::locate(context.view, halfspace, block);
    if (known == csg::Known::in) continue;
    result.nothing = result.nothing || known == csg::Known::out;
    if (known == csg::Known::depends) require_representable(context, primitive, halfspace);
    result.halfspaces.push_back(halfspace);
  }
  return result;
}

const view::FixedLinear& linear_of(const Context& context, facet::Halfspace halfspace) {
  return context.view.planes[halfspace.plane].linear;
}

view::Range range_of(const Context& context, facet::Halfspace halfspace, const view::PixelRect& pixels) {
  return csg::depth_range(context.view.planes[halfspace.plane], context.view.sampling.fraction_bits, pixels);
}

/// Z1 := the nearest or farthest of the facets, starting from a facet that fits Z1 from the outset where there is one,
/// else from the bound of the depth range. Returns whether the bound was needed.
bool emit_extreme(const Context& context, Broadcast& out, const std::vector<facet::Halfspace>& facets,
                  bool farthest_front, const view::PixelRect& pixels) {
  const isa::Field z1 = context.layout.candidate;
  const auto first = std::find_if(facets.begin(), facets.end(), [&](const facet::Halfspace& facet) {
    const view::Range range = range_of(context, facet, pixels);
    return farthest_front ? range.low >= 0 : range.high <= context.farthest();
  });
  const bool bounded = first == facets.end();
  if (bounded) {
    out.plain(Opcode::set_constant, z1, {}, farthest_front ? 0 : static_cast<std::uint64_t>(context.farthest()));
  } else {
    out.surface(Opcode::load_linear, z1, linear_of(context, *first), pixels);
  }
  for (auto facet = facets.begin(); facet != facets.end(); ++facet) {
    if (facet == first) continue;
    out.surface(farthest_front ? Opcode::keep_max : Opcode::keep_min, z1, linear_of(context, *facet), pixels);
  }
  return bounded;
}

/// A subtracted solid has no back where it ends before the near plane.
void emit_near_test(const Context& context, Broadcast& out, const std::vector<facet::Halfspace>& backs,
                    const view::PixelRect& pixels) {
  const bool reaches = std::any_of(backs.begin(), backs.end(), [&](const facet::Halfspace& back) {
    return range_of(context, back, pixels).low <= 0;
  });
  if (reaches) out.surface(Opcode::linear_lt, context.layout.candidate, {0, 0, 0}, pixels);
}

glm::dvec3 facet_normal(const Context& context, facet::Halfspace facet, bool complemented) {
  const glm::dvec3& normal = context.scene.planes.planes()[facet.plane].normal;
  const view::Basis axes = view::basis(context.view.camera);
  const double sign = facet.positive != complemented ? 1.0 : -1.0;
  return sign * glm::dvec3(glm::dot(normal, axes.right), glm::dot(normal, axes.up), glm::dot(normal, axes.forward));
}

}  // namespace

void require_representable(const Context& context, std::uint32_t primitive, facet::Halfspace halfspace) {
  if (context.view.planes[halfspace.plane].representable) return;
  const model::Location& location = context.tree.primitives[primitive].location;
  throw InputError(context.tree.file + ":" + std::to_string(location.line) + ":" + std::to_string(location.column) +
                   ": a face of this primitive is too large for the picture: its coefficients do not fit " +
                   std::to_string(isa::max_linear_width) +
                   " bits; move the camera back or the picture's centre onto it, give up --z-bits or --fraction-bits, "
                   "or split the primitive");
}

void emit_edges(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block) {
  for (const facet::Halfspace& halfspace : context.scene.solids[primitive].halfspaces) {
    const view::ScreenPlane& plane = context.view.planes[halfspace.plane];
    if (plane.kind != view::PlaneKind::edge || csg::locate(context.view, halfspace, block) == csg::Known::in) continue;
    require_representable(context, primitive, halfspace);
    const bool positive = view::side_of(plane, halfspace) == Side::edge_positive;
    out.edge(positive ? Opcode::edge_not_negative : Opcode::edge_negative, plane.linear, block.pixels);
  }
}

Surface emit_surface(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block) {
  const bool complemented = context.complemented(primitive);
  const view::PixelRect screen{0, 0, static_cast<std::int32_t>(context.view.sampling.width) - 1,
                               static_cast<std::int32_t>(context.view.sampling.height) - 1};
  // Half-spaces decide over the whole depth range: Z1 is not known yet.
  const csg::Block column{block.pixels, 0, context.farthest()};
  const Deciding fronts = deciding(context, primitive, Side::front, column);
  const Deciding backs = deciding(context, primitive, Side::back, column);
  const std::vector<facet::Halfspace>& facets = complemented ? backs.halfspaces : fronts.halfspaces;

  Surface surface{false, false, facets, block};
  surface.nothing = fronts.nothing || backs.nothing || (complemented && facets.empty());
  if (surface.nothing) return surface;

  out.plain(Opcode::enable_all);
  out.clip(block.pixels, screen);
  emit_edges(context, out, primitive, column);
  const bool bounded = emit_extreme(context, out, facets, !complemented, block.pixels);
  surface.near_cap = bounded && !complemented;
  const std::vector<facet::Halfspace>& others = complemented ? fronts.halfspaces : backs.halfspaces;
  for (const facet::Halfspace& other : others) {
    out.surface(complemented ? Opcode::linear_lt : Opcode::linear_gt, context.layout.candidate,
                linear_of(context, other), block.pixels);
  }
  if (complemented) emit_near_test(context, out, facets, block.pixels);
  out.plain(Opcode::enable_store, context.layout.mask);
  return surface;
}

void emit_merge(const Context& context, Broadcast& out, std::uint32_t primitive, const Surface& surface) {
  const Layout& layout = context.layout;
  out.origin.purpose = isa::Purpose::merge;
  out.plain(Opcode::enable_load, layout.mask);
  out.plain(Opcode::field_lt, layout.candidate, layout.depth);
  out.plain(Opcode::enable_store, layout.mask);
  out.plain(Opcode::copy, layout.depth, layout.candidate);

  out.origin.purpose = isa::Purpose::shade;
  const bool complemented = context.complemented(primitive);
  const glm::dvec3 colour = context.tree.primitives[primitive].colour.value_or(
      complemented ? effects::default_cut_colour : effects::default_colour);
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    const facet::Halfspace facet = surface.facets[i];
    // What no facet before it was, the last one is, unless the near plane can be it.
    const bool rest = i + 1 == surface.facets.size() && !surface.near_cap;
    if (i > 0) out.plain(Opcode::enable_load, layout.mask);
    if (!rest) out.surface(Opcode::linear_eq, layout.candidate, linear_of(context, facet), surface.block.pixels);
    out.plain(Opcode::set_constant, layout.colour, {},
              effects::shade(context.shading, colour, facet_normal(context, facet, complemented)));
    if (!rest) out.plain(Opcode::set_constant, layout.mask, {}, 0);
  }
  if (surface.near_cap) {
    if (!surface.facets.empty()) out.plain(Opcode::enable_load, layout.mask);
    out.plain(Opcode::set_constant, layout.colour, {}, effects::shade(context.shading, colour, {0, 0, -1}));
  }
}

}  // namespace csgsim::emit
