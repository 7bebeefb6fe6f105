#include "hw/machines/area.h"

#include <algorithm>

#include "hw/machines/area_table.h"
#include "hw/machines/kind.h"

namespace csgsim::machines {

std::optional<std::uint64_t> pixel_transistors(const Machine& machine, std::uint32_t memory_bits) {
  if (!machine.kind->bit_serial_pixels()) return std::nullopt;
  const auto logic = std::ranges::find_if(pixel_logic_table, [&](const PixelLogic& row) {
    return row.alu_bits == machine.alu_bits && row.memory_reads == machine.memory_reads &&
           row.degree == machine.evaluator_degree;
  });
  const auto node = std::ranges::find_if(node_logic_table, [&](const NodeLogic& row) {
    return row.bits == machine.evaluator_bits && row.degree == machine.evaluator_degree;
  });
  if (logic == pixel_logic_table.end() || node == node_logic_table.end()) return std::nullopt;
  return std::uint64_t{memory_bits} * cell_transistors(machine.memory_reads) + logic->transistors + node->transistors;
}

}  // namespace csgsim::machines
