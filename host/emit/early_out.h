// Skips over instructions that no pixel would execute.
// Used by host/effects.
#pragma once

#include <cstddef>

#include "host/emit/context.h"

namespace csgsim::emit {

/// Makes the instructions appended from `begin` on conditional: they are skipped if E is 0 at all pixels before them.
/// Nothing is inserted if early-out pruning is off, the machine has no global OR, or the skipped instructions take too
/// few clocks. The test gets `origin`. Skips appended before must not span `begin`.
void emit_early_out(const Context& context, Broadcast& out, std::size_t begin, const isa::Origin& origin);

}  // namespace csgsim::emit
