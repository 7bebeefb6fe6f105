#pragma once

#include <cstdint>
#include <span>

#include "hw/division/counts.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/records.h"
#include "hw/multi_processor/word_processor.h"

namespace csgsim::multi_processor {

/// Clocks of a processor for the counted tests.
constexpr std::uint64_t clocks_of(const division::Counts& counts, const TestClocks& each) {
  return counts.boxes * each.primitive + counts.halfspaces * each.halfspace + counts.cells * each.cell +
         counts.nodes * each.tree_node + counts.instructions * each.instruction;
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
