#include "host/emit/effect.h"

#include <algorithm>

#include "host/emit/facet_colour.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

bool has_shaders(const Context& context) {
  return std::any_of(context.options.effects.begin(), context.options.effects.end(),
                     [](const CalledEffect& one) { return one.effect->shade != nullptr; });
}

void emit_colour(const Context& context, Broadcast& out, const Facet& facet, isa::Field field,
                 const view::PixelRect& pixels) {
  for (const CalledEffect& one : context.options.effects) {
    if (one.effect->shade != nullptr && one.effect->shade(one.settings, context, out, facet, field, pixels)) return;
  }
  out.plain(isa::Opcode::set_constant, field, {}, facet_colour(context, facet));
}

}  // namespace csgsim::emit
