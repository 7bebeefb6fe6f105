#pragma once

#include <cstdint>

#include "hw/division/counts.h"
#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

/// That a processor takes for what it has done.
constexpr std::uint64_t clocks_of(const division::Counts& counts, const TestClocks& each) {
  return counts.boxes * each.primitive + counts.halfspaces * each.halfspace + counts.cells * each.cell +
         counts.nodes * each.tree_node + counts.instructions * each.instruction;
}

}  // namespace csgsim::multi_processor
