// Instructions that compare a surface in Z1 with primitives of its active tree.
// Used by the classification strategies (levels, labels, parallel).
#pragma once

#include "host/emit/context.h"

namespace csgsim::emit {

/// E := E and "Z1 is in the primitive", tested with all half-spaces that matter where the surface can be. `surface`
/// is the surface in Z1. The caller sets the origin of the instructions that follow.
void emit_comparison(const Context& context, Broadcast& out, std::uint32_t primitive, const PlannedSurface& surface);

/// E := E and "Z1 is in all primitives of the leaf", even if the leaf is complemented. Returns the number of
/// primitives.
std::uint32_t emit_comparison(const Context& context, Broadcast& out, const csg::ActiveNode& leaf,
                              const PlannedSurface& surface);

/// bit := bit and "Z1 is in the leaf". Returns the number of primitives compared with Z1.
std::uint32_t emit_intersection(const Context& context, Broadcast& out, const csg::ActiveNode& leaf,
                                const PlannedSurface& surface, isa::Field bit);

/// Appends an instruction that combines results of the classification of a primitive's surface.
void emit_stack(Broadcast& out, isa::Opcode opcode, isa::Field field, std::uint64_t constant = 0);

}  // namespace csgsim::emit
