#pragma once

#include <cstdint>
#include <span>

#include "hw/division/counts.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/records.h"
#include "hw/multi_processor/word_processor.h"

namespace csgsim::multi_processor {

/// Clocks that a processor takes for the counted tests, at `test_clocks` each.
constexpr std::uint64_t clocks_of(const division::Counts& counts, const TestClocks& test_clocks) {
  return counts.boxes * test_clocks.primitive + counts.halfspaces * test_clocks.halfspace +
         counts.cells * test_clocks.cell + counts.nodes * test_clocks.tree_node +
         counts.instructions * test_clocks.instruction;
}

/// Clocks of a node's tests, including unpacking of the tested numbers.
inline TestClocks node_test_costs(const RecordFormat& format, const Figures& figures) {
  const auto unpacking = [&](const auto& numbers) {
    WordProcessor processor(figures);
    processor.unpack(std::span<const unsigned>(numbers));
    return static_cast<std::uint32_t>(processor.clocks());
  };
  TestClocks each = figures.node_tests;
  each.primitive += unpacking(format.box_numbers());
  each.halfspace += unpacking(format.halfspace_numbers());
  each.tree_node += unpacking(format.node_numbers());
  return each;
}

}  // namespace csgsim::multi_processor
