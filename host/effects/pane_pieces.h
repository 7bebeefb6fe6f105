#pragma once

#include <cstdint>
#include <vector>

#include "host/emit/effect.h"

namespace csgsim::effects {

/// By primitive: other convex pieces of the same node of the file that it may touch. Of pieces that are not drawn, and
/// of those that are taken away, none.
std::vector<std::vector<std::uint32_t>> touching_pieces(const emit::Drawing& drawing, const std::vector<bool>& drawn);

/// E stays 1 where Z1, the surface of a piece, is in none of the pieces that it touches: neither within one nor where
/// the ray leaves it, so that pieces that meet in a face, or overlap, are seen as one solid. Where the ray enters
/// several at one depth all of them stay. `spare` is one bit to keep E in.
void emit_outside(const emit::Context& context, emit::Broadcast& out, const emit::PlannedSurface& planned,
                  const std::vector<std::uint32_t>& pieces, isa::Field spare);

}  // namespace csgsim::effects
