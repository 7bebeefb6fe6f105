// Draws primitives: surface, classification by the chosen strategy, and merge.
// Used by the strategies and drawing.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/emit/surface.h"

namespace csgsim::emit {

/// Memory bits of the strategy for the whole drawing. Throws InputError if the tree has more products than
/// max_products.
ClassificationBits classification_bits(const Drawing& drawing, const Options& options);

/// Draws one primitive's surface where its active tree contains it and it is visible. `options.strategy` must not be
/// automatic.
void emit_primitive(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides);

/// How a surface is classified.
struct Classification {
  /// Clears the mask where Z1 is outside the active tree, which must have operands. Returns the number of primitives
  /// compared with Z1.
  std::uint64_t (*classify)(const Context& context, Broadcast& out, const PlannedSurface& surface);
  const PlannedSurface& surface;  ///< owner of the active tree
};

/// Merges the surface in Z1 where the classification leaves the mask 1. Returns whether it
/// appended an instruction.
bool emit_classified(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                     const Classification& classification);

/// Skips what was appended from `begin` on, right after a depth test, if no pixel passes the test.
void emit_depth_early_out(const Context& context, Broadcast& out, const PlannedSurface& planned, std::size_t begin);

/// Skips the surface if it covers none of the pixels to which the drawing is restricted.
void emit_base_early_out(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface);

/// Draws the surface in Z1 where it is nearer than Z2 and the classification leaves the mask 1. The depth test comes
/// first, because nothing has to be classified if no pixel passes it.
void emit_visible(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                  const Classification& classification);

}  // namespace csgsim::emit
