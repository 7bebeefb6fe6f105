#pragma once

#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

/// Replaces each member that is machines::not_priced. A clock count becomes the clocks of its task
/// (hw/host/node_recipes.h) on its processor, times the compiler factor, rounded up. A compiler factor becomes that of
/// the processor.
void compute_processor_clocks(Figures& figures);

}  // namespace csgsim::multi_processor
