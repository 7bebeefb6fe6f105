#pragma once

#include <span>
#include <vector>

#include "host/effects/shadow_parts.h"
#include "host/emit/broadcast.h"

namespace csgsim::effects {

/// Sets `flag` where any of the parts is, and clears it elsewhere, at the context's pixels. What parts have in common
/// is broadcast once for them, for as long as `marks` has bits to remember where it holds.
void emit_shadows(const emit::Context& context, emit::Broadcast& out, std::span<const ShadowPart> parts,
                  isa::Field flag, isa::Field marks);

}  // namespace csgsim::effects
