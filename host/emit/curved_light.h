// Diffuse and ambient light on curved facets, computed at every pixel.
// Used by flat shading and the layout of quadrics.
#pragma once

#include "host/emit/broadcast.h"
#include "host/emit/context.h"
#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// Bits of the layout's sum that lighting needs for colours of `colour_bits` bits.
unsigned light_bits(unsigned colour_bits);

/// Writes the diffuse and ambient light on a curved facet to `field` where E is 1. Each pixel computes it from Z1,
/// which has to hold the facet's depth: the cosine of a light is a linear expression plus or minus a part of the depth
/// (light_fit.h), and its contribution to a channel is a sum of shifted cosines. Overwrites the layout's sum and
/// `kept`.
void emit_curved_light(const Context& context, Broadcast& out, const Facet& facet, isa::Field field,
                       const view::PixelRect& pixels);

}  // namespace csgsim::emit
