#pragma once

#include "host/emit/context.h"

namespace csgsim::emit {

/// Bits of the label that a pixel keeps while the active tree is worked out as an ordered Boolean list.
unsigned label_bits(const csg::ActiveTree& active);

/// Clears the mask where Z1 is out of the active tree, leaf after leaf (csg::OrderedList). Returns how many primitives
/// were compared with Z1.
std::uint64_t emit_list(const Context& context, Broadcast& out, const PlannedSurface& planned);

}  // namespace csgsim::emit
