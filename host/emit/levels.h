// Classification by a stack for the first levels of a tree and by products below.
// Used by the strategies stack, bits, stored and polygons.
#pragma once

#include "host/emit/context.h"

namespace csgsim::emit {

/// The first levels of a tree are evaluated with a stack, and the subtrees below by repeated traversal, as sums of
/// products (thesis 6.4). Levels count from the root of the active tree, including its topmost intersection, which the
/// mask accumulates. `all_levels` means that the whole tree is evaluated with the stack.
inline constexpr unsigned all_levels = 0xffffffffU;

/// Number of products traversed below the levels; csg::countless on overflow.
std::uint64_t products_below_levels(const csg::ActiveTree& active, unsigned levels);

ClassificationBits bits_for_levels(const csg::ActiveTree& active, unsigned levels);

/// Clears the mask where Z1 is outside the active tree. Returns the number of primitives compared with Z1.
std::uint64_t emit_by_levels(const Context& context, Broadcast& out, const PlannedSurface& planned, unsigned levels);

/// bits_for_levels() and emit_by_levels() for all levels of the tree, with the signatures of StrategyRow.
ClassificationBits bits_for_all_levels(const csg::ActiveTree& active, const Options& options);
std::uint64_t emit_by_all_levels(const Context& context, Broadcast& out, const PlannedSurface& planned);

}  // namespace csgsim::emit
