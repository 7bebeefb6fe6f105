#include "host/emit/shading.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "host/emit/early_out.h"
#include "host/emit/effect.h"
#include "hw/base/error.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;

/// Maximum number of shadows on one facet: each doubles the number of its colours.
constexpr std::size_t max_shadows = 6;

using ShadowBits = std::vector<const ShadowBit*>;

/// The lighting with one light turned off.
lighting::Lighting without_light(lighting::Lighting lighting, std::size_t light) {
  lighting.lights[light].colour = {0, 0, 0};
  return lighting;
}

std::vector<isa::Instruction> colour_under(const Context& context, const Facet& facet, const view::PixelRect& pixels,
                                           const lighting::Lighting& lights) {
  isa::Segment segment{context.plan.region, {}, {}};
  Broadcast out(segment, context.view.sampling, context.options.work);
  Context lit = context;
  lit.lights = &lights;
  emit_colour(lit, out, facet, context.layout.colour, pixels);
  return std::move(segment.instructions);
}

/// The shadows that fall on the facet and change its colour.
ShadowBits relevant_shadows(const Context& context, const Facet& facet, const view::PixelRect& pixels,
                            const std::vector<ShadowBit>& bits) {
  ShadowBits matter;
  if (facet.at != At::plane) return matter;
  for (const ShadowBit& bit : bits) {
    const std::pair facet_of{facet.primitive, facet.halfspace};
    const bool falls_on = std::find(bit.facets.begin(), bit.facets.end(), facet_of) != bit.facets.end();
    if (falls_on && light_matters(context, facet, pixels, bit.light)) matter.push_back(&bit);
  }
  if (matter.size() > max_shadows) {
    throw InputError(fmt::format("the shadows of {} lights meet on one facet; let at most {} lights cast shadows",
                                 matter.size(), max_shadows));
  }
  return matter;
}

/// Writes the facet's colour, and over it, for each set of lights, the colour without them where all of them are in
/// shadow. A set comes after its subsets.
void emit_shadowed_colour(const Context& context, Broadcast& out, const Facet& facet, isa::Field field,
                          const view::PixelRect& pixels, const ShadowBits& bits, isa::Field spare) {
  if (!bits.empty()) out.plain(Opcode::enable_store, spare);
  emit_colour(context, out, facet, field, pixels);
  const std::uint32_t sets = 1U << bits.size();
  for (int size = 1; size <= static_cast<int>(bits.size()); ++size) {
    for (std::uint32_t dark = 1; dark < sets; ++dark) {
      if (std::popcount(dark) != size) continue;
      out.plain(Opcode::enable_load, spare);
      lighting::Lighting lights = context.lighting();
      for (std::size_t i = 0; i < bits.size(); ++i) {
        if (((dark >> i) & 1U) == 0) continue;
        out.plain(Opcode::enable_and, bits[i]->bit);
        lights = without_light(std::move(lights), bits[i]->light);
      }
      Context lit = context;
      lit.lights = &lights;
      emit_colour(lit, out, facet, field, pixels);
    }
  }
}

/// E stays 1 where the field holds the facet's depth.
void emit_seen_at(const Context& context, Broadcast& out, const Facet& facet, isa::Field depth,
                  const view::PixelRect& pixels) {
  if (is_curved(facet.at)) {
    out.plain(Opcode::field_eq, depth, emit_facet_depth(context, out, facet, pixels, pixels));
  } else {
    out.surface(Opcode::linear_eq, depth, facet_plane(context, facet), pixels);
  }
}

}  // namespace

bool has_shaders(const Context& context) {
  if (context.paint != nullptr) return false;
  for (std::size_t i = 1; i < context.called.size(); ++i)
    if (context.called[i].row->parts.shades && ((context.left_out >> i) & 1U) == 0) return true;
  return false;
}

bool light_matters(const Context& context, const Facet& facet, const view::PixelRect& pixels, std::size_t light) {
  const lighting::Lighting dark = without_light(context.lighting(), light);
  return colour_under(context, facet, pixels, context.lighting()) != colour_under(context, facet, pixels, dark);
}

void emit_colour(const Context& context, Broadcast& out, const Facet& facet, isa::Field field,
                 const view::PixelRect& pixels) {
  if (context.paint != nullptr) {
    out.plain(Opcode::set_constant, field, {}, (*context.paint)(facet));
    return;
  }
  // The last effect that accepts the facet colours it; flat shading, the first, accepts all.
  for (std::size_t i = context.called.size(); i-- > 0;) {
    if (((context.left_out >> i) & 1U) != 0) continue;
    const Billing billing(out, i);
    if (context.called[i].effect->shade({*(*context.states)[i], context}, out, facet, field, pixels)) return;
  }
}

void emit_facet_colours(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                        isa::Field depth, const Shadows& shadows) {
  const isa::Field mask = context.layout.mask;
  for (std::size_t i = 0; i < surface.facets.size(); ++i) {
    const Facet& facet = surface.facets[i];
    const bool is_rest = i + 1 == surface.facets.size();
    out.origin = facet_origin(isa::Purpose::shade, planned, facet);
    if (i > 0) out.plain(Opcode::enable_load, mask);
    if (!is_rest) emit_seen_at(context, out, facet, depth, surface.block.pixels);
    const ShadowBits bits = relevant_shadows(context, facet, surface.block.pixels, shadows.bits);
    const bool mask_first = has_shaders(context) || !bits.empty();
    if (!is_rest && mask_first) out.plain(Opcode::set_constant, mask, {}, 0);
    emit_shadowed_colour(context, out, facet, context.layout.colour, surface.block.pixels, bits, shadows.spare);
    if (!is_rest && !mask_first) out.plain(Opcode::set_constant, mask, {}, 0);
  }
}

void emit_visible_colours(const Context& context, Broadcast& out, const PlannedSurface& planned,
                          const Shadows& shadows) {
  const Surface surface = plan_surface(context, planned, deciding_sides(context, planned));
  if (surface.nothing) return;
  out.origin = {isa::Purpose::shade, planned.primitive(), isa::no_node};
  enable_drawing(context, out);
  out.equals(context.layout.owner, planned.number);
  const std::size_t begin = out.size();
  if (surface.facets.size() > 1) out.plain(Opcode::enable_store, context.layout.mask);
  emit_facet_colours(context, out, planned, surface, context.layout.depth, shadows);
  emit_early_out(context, out, begin, {isa::Purpose::shade, planned.primitive(), isa::no_node});
}

}  // namespace csgsim::emit
