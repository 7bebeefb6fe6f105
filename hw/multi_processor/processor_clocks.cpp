#include "hw/multi_processor/processor_clocks.h"

#include <array>
#include <cstdint>

#include "hw/base/quotient.h"
#include "hw/host/node_recipes.h"
#include "hw/machines/host.h"
#include "hw/machines/schema.h"
#include "hw/processors/processor.h"

namespace csgsim::multi_processor {

namespace {

using processors::Operation;
using processors::operation_counts;
using processors::Operations;

/// A member and its task.
struct Task {
  std::uint32_t& clocks;
  Operations each;
};

Operations single(Operation kind) { return operation_counts({{kind, 1}}); }

void compute_processor_clocks(const Task& task, const processors::Processor& processor, std::uint32_t compiler_factor) {
  if (task.clocks != machines::not_priced) return;
  constexpr std::uint64_t hand_written = 1000;
  task.clocks = static_cast<std::uint32_t>(
      quotient_up(processors::hand_written_clocks(task.each, processor) * compiler_factor, hand_written));
}

const processors::Processor& complete(ProcessorFigures& figures) {
  const processors::Processor& processor = processors::built_in_processor(machines::processor_names.at(figures.type));
  if (figures.compiler_factor == machines::not_priced)
    figures.compiler_factor = processor.compiler_factors[static_cast<std::size_t>(processors::Compiled::general)];
  return processor;
}

}  // namespace

void compute_processor_clocks(Figures& figures) {
  const processors::Processor& display = complete(figures.display_processor);
  TestClocks& first = figures.display_tests;
  for (const Task& task : std::to_array<Task>({{figures.transform_clocks, host::plane_transform_operations()},
                                               {first.primitive, host::box_test_operations()},
                                               {first.halfspace, host::halfspace_test_operations()},
                                               {first.cell, host::cell_test_operations()}}))
    compute_processor_clocks(task, display, figures.display_processor.compiler_factor);

  const processors::Processor& node = complete(figures.node_processor);
  OperationClocks& words = figures.operations;
  TestClocks& second = figures.node_tests;
  for (const Task& task : std::to_array<Task>({{words.read, single(Operation::load)},
                                               {words.write, single(Operation::store)},
                                               {words.add, single(Operation::add)},
                                               {words.compare, single(Operation::compare)},
                                               {words.logic, single(Operation::logic)},
                                               {words.multiply, single(Operation::multiply)},
                                               {words.shift, single(Operation::shift)},
                                               {words.shift_bit, single(Operation::shifted_bit)},
                                               {figures.branches.taken, single(Operation::branch_taken)},
                                               {figures.branches.passed, single(Operation::branch)},
                                               {figures.field_clocks, host::field_search_operations()},
                                               {figures.chain.link, host::call_linking_operations()},
                                               {figures.chain.call, host::call_operations()},
                                               {figures.loop.pixel, host::pixel_loop_operations()},
                                               {figures.loop.row, host::row_loop_operations()},
                                               {figures.loop.instruction, host::instruction_loop_operations()},
                                               {second.primitive, host::box_test_operations()},
                                               {second.halfspace, host::halfspace_test_operations()},
                                               {second.cell, host::cell_test_operations()},
                                               {second.tree_node, host::node_visit_operations()},
                                               {second.instruction, host::instruction_listing_operations()},
                                               {figures.number_clocks, host::number_listing_operations()}}))
    compute_processor_clocks(task, node, figures.node_processor.compiler_factor);
}

}  // namespace csgsim::multi_processor
