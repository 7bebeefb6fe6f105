#pragma once

#include <cstddef>
#include <cstdint>

#include "host/emit/surface.h"

namespace csgsim::emit {

/// Memory bits that the strategy takes for the whole drawing. Throws InputError where it cannot do it (see
/// most_products).
ClassificationBits classification_bits(const Drawing& drawing, const Options& options);

/// Draws one primitive's visible surface where its active tree holds it. `options.strategy` must not be automatic.
void emit_primitive(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides);

/// How a surface is classified.
struct Classification {
  /// Clears the mask where Z1 is out of the active tree, which has operands. Returns how many primitives were compared
  /// with Z1.
  std::uint64_t (*classify)(const Context& context, Broadcast& out, const PlannedSurface& surface);
  const PlannedSurface& surface;  ///< whose active tree it is
};

/// Merges the surface in Z1 where the classification leaves the mask. Whether that took any instruction.
bool emit_classified(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                     const Classification& classification);

/// What was appended from `begin` on, right after a depth test, is skipped where that leaves nothing.
void emit_depth_early_out(const Context& context, Broadcast& out, const PlannedSurface& planned, std::size_t begin);

/// Skips the surface if it has none of the pixels to which the drawing is restricted.
void emit_base_early_out(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface);

/// Draws the surface in Z1 where it is nearer than Z2 and what is left of the mask by the classification. The depth
/// test comes first: where it leaves nothing, nothing has to be classified.
void emit_visible(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                  const Classification& classification);

}  // namespace csgsim::emit
