#pragma once

#include "host/emit/context.h"

namespace csgsim::emit {

/// E := E and "Z1 is in the primitive", by all half-spaces that matter where the surface can be. `of` is what has its
/// surface in Z1. The origin of what comes after is left to whoever emits it.
void emit_comparison(const Context& context, Broadcast& out, std::uint32_t primitive, const PlannedSurface& of);

/// The same for the intersection of all primitives of a leaf, complemented or not. Returns how many these are.
std::uint32_t emit_comparison(const Context& context, Broadcast& out, const csg::ActiveNode& leaf,
                              const PlannedSurface& of);

/// bit := bit and the leaf. Returns how many primitives were compared.
std::uint32_t emit_intersection(const Context& context, Broadcast& out, const csg::ActiveNode& leaf,
                                const PlannedSurface& of, isa::Field bit);

/// Appends an instruction that belongs to working out the classification of a primitive's surface.
void emit_stack(Broadcast& out, isa::Opcode opcode, isa::Field field, std::uint64_t constant = 0);

}  // namespace csgsim::emit
