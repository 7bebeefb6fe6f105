#pragma once

#include "hw/division/active_tree.h"
#include "hw/division/writer.h"

namespace csgsim::division {

/// Clears the mask where Z1 is outside the active tree; intermediate results are kept on a stack of bits. E is
/// undefined afterwards. Throws InputError if the tree needs more intermediate results than there are bits.
void write_classification(Writer& out, Datapath& path, const ActiveTree& active, const Surface& surface);

}  // namespace csgsim::division
