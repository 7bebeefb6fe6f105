#pragma once

#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

/// Replaces each member that is machines::not_priced by the clocks of its task (hw/host/node_recipes.h) at the prices
/// of its processor, times the compiler factor, rounded up. An unpriced compiler factor becomes the processor's.
void price(Figures& figures);

}  // namespace csgsim::multi_processor
