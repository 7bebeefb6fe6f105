#include "hw/machines/area.h"

#include <algorithm>
#include <cmath>

#include "hw/machines/area_table.h"
#include "hw/machines/clocks.h"
#include "hw/machines/kind.h"

namespace csgsim::machines {

namespace {

/// A flip-flop in the synthesis: as counted by Yosys, and two dynamic latches.
constexpr Transistors register_transistors{16, 6};

double in_family(const Transistors& transistors, LogicFamily family) {
  return family == LogicFamily::cmos ? transistors.cmos : transistors.nmos;
}

}  // namespace

/// Level k of the tree has 2^k nodes.
double registered_node_fraction(const Machine& machine) {
  const std::uint32_t levels = tree_levels(machine.array.height);
  if (levels == 0) return 1;
  std::uint64_t registered = 0;
  for (std::uint32_t level = 0; level < levels; ++level) {
    const bool is_last = level + 1 == levels;
    if (is_last || (level + 1) % machine.register_levels == 0) registered += std::uint64_t{1} << level;
  }
  return static_cast<double>(registered) / static_cast<double>((std::uint64_t{1} << levels) - 1);
}

std::optional<std::uint64_t> logic_transistors(const Machine& machine, LogicFamily family) {
  if (!machine.kind->bit_serial_pixels()) return std::nullopt;
  const auto logic = std::ranges::find_if(pixel_logic_table, [&](const PixelLogic& row) {
    return row.alu_bits == machine.alu_bits && row.memory_reads == machine.memory_reads &&
           row.degree == machine.evaluator_degree;
  });
  const auto node = std::ranges::find_if(node_logic_table, [&](const NodeLogic& row) {
    return row.bits == machine.evaluator_bits && row.degree == machine.evaluator_degree;
  });
  if (logic == pixel_logic_table.end() || node == node_logic_table.end()) return std::nullopt;
  const double streams = (machine.evaluator_degree == 1 ? 2.0 : 4.0) * machine.evaluator_bits;
  const double left_out = (1 - registered_node_fraction(machine)) * streams * in_family(register_transistors, family);
  return static_cast<std::uint64_t>(
      std::llround(in_family(logic->transistors, family) + in_family(node->transistors, family) - left_out));
}

std::optional<std::uint64_t> pixel_transistors(const Machine& machine, std::uint32_t memory_bits) {
  const std::optional<std::uint64_t> logic = logic_transistors(machine, LogicFamily::cmos);
  if (!logic) return std::nullopt;
  return std::uint64_t{memory_bits} * cell_transistors(machine.memory_reads) + *logic;
}

}  // namespace csgsim::machines
