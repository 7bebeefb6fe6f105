#pragma once

#include "host/emit/broadcast.h"
#include "host/emit/context.h"
#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// Bits of the layout's sum that it takes to light colours of that many bits.
unsigned light_bits(unsigned colour_bits);

/// The diffuse and ambient light on a curved facet into `field` where E is 1, worked out at every pixel from Z1, which
/// has to hold the facet's depth: each light's cosine is a linear expression plus or minus a part of the depth
/// (light_fit.h), and what it adds to a channel a sum of shifted cosines. Writes the layout's sum, and `kept`.
void emit_curved_light(const Context& context, Broadcast& out, const Facet& facet, isa::Field field,
                       const view::PixelRect& pixels);

}  // namespace csgsim::emit
