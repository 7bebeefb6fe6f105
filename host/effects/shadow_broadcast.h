// Instructions that find the pixels in shadow.
// Used by the shadow effect.
#pragma once

#include <span>
#include <vector>

#include "host/effects/shadow_parts.h"
#include "host/emit/broadcast.h"

namespace csgsim::effects {

/// Sets `flag` in all parts and clears it elsewhere, at the context's pixels. A plane that several parts share is
/// broadcast once, as long as `marks` has bits to store the result.
void emit_shadows(const emit::Context& context, emit::Broadcast& out, std::span<const ShadowPart> parts,
                  isa::Field flag, isa::Field marks);

}  // namespace csgsim::effects
