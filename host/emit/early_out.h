#pragma once

#include <cstddef>

#include "host/emit/context.h"

namespace csgsim::emit {

/// Has everything that was appended from `begin` on skipped where E is 1 at no pixel before it: if such pruning is
/// asked for, the machine can answer, and what is skipped takes several times the clocks of the question. The question
/// gets that origin. Skips appended before must not reach beyond `begin`.
void emit_early_out(const Context& context, Broadcast& out, std::size_t begin, const isa::Origin& origin);

}  // namespace csgsim::emit
