#pragma once

#include <cstdint>

#include "host/emit/broadcast.h"

namespace csgsim::emit {

/// Where E is 1: field := constant. The field may have any width.
void emit_constant(Broadcast& out, isa::Field field, std::uint64_t constant);

/// Where E is 1: target := source * 2^up, as much of it as fits the target, which may have any width. They may
/// be the same bits where nothing is shifted.
void emit_shifted(Broadcast& out, isa::Field source, isa::Field target, unsigned up);

}  // namespace csgsim::emit
