// Joints between pieces of one transparent solid.
// Used by layers.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "host/emit/effect.h"

namespace csgsim::effects {

/// For each primitive, the other convex pieces of the same node of the file that it may touch. Empty for pieces that
/// are not drawn and for subtracted pieces.
std::vector<std::vector<std::uint32_t>> touching_pieces(const emit::Drawing& drawing, const std::vector<bool>& drawn);

/// Leaves E at 1 where Z1, the surface of a piece, is in none of the pieces that it touches: neither inside such a
/// piece nor where the ray leaves it. Pieces that overlap or meet in a face then look like one solid. Where the ray
/// enters several pieces at the same depth, all stay. `spare` is one bit for saving E.
void emit_outside(const emit::Context& context, emit::Broadcast& out, const emit::PlannedSurface& planned,
                  const std::vector<std::uint32_t>& pieces, isa::Field spare);

}  // namespace csgsim::effects
