#pragma once

#include "host/emit/context.h"

namespace csgsim::emit {

/// A tree whose first levels are worked out by a stack, and whose subtrees below by repeated traversal, their products
/// summed (thesis 6.4). The levels are those of the active tree, its topmost intersection included, which the mask
/// accumulates.
inline constexpr unsigned all_levels = 0xffffffffU;

/// Products that are gone through below the levels; csg::countless if there are more than fit.
std::uint64_t products_below_levels(const csg::ActiveTree& active, unsigned levels);

ClassificationBits bits_for_levels(const csg::ActiveTree& active, unsigned levels);

/// Clears the mask where Z1 is out of the active tree. Returns how many primitives were compared with Z1.
std::uint64_t emit_by_levels(const Context& context, Broadcast& out, const PlannedSurface& planned, unsigned levels);

/// The same of all levels, as StrategyRow has them.
ClassificationBits bits_for_all_levels(const csg::ActiveTree& active, const Options& options);
std::uint64_t emit_by_all_levels(const Context& context, Broadcast& out, const PlannedSurface& planned);

}  // namespace csgsim::emit
