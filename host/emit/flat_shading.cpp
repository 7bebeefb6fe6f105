#include "host/emit/flat_shading.h"

#include <array>

#include "host/emit/curved_light.h"
#include "host/emit/facet_colour.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

struct Settings {};

bool shade(const EffectCall& call, Broadcast& out, const Facet& facet, isa::Field field,
           const view::PixelRect& pixels) {
  if (is_curved(facet.at)) {
    emit_curved_light(call.context, out, facet, field, pixels);
    return true;
  }
  out.plain(isa::Opcode::set_constant, field, {}, facet_colour(call.context, facet));
  return true;
}

constexpr std::array rows{&flat};

}  // namespace

const Effect flat{
    .section =
        {"effects.flat", "every facet in one colour", false, {}, scene::blank_section<Settings>, scene::keep_effect},
    .technique =
        "Lambert's law and Blinn's highlights (Models of Light Reflection for Computer "
        "Synthesized Pictures, SIGGRAPH 1977), worked out once a facet by the host",
    .called_by = [](const Look&) { return true; },
    .takes_quadrics = true,
    .shade = shade};

std::span<const Effect* const> flat_alone() { return rows; }

}  // namespace csgsim::emit
