#pragma once

#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/row_map.h"
#include "hw/isa/instruction.h"

namespace csgsim::bit_serial_memory {

/// Machine parameters that its micro-programs depend on.
struct MicroDesign {
  Design design = Design::latches;
  Expressions expressions = Expressions::rows;
  bool enable_latch = false;
  bool has_wired_or = false;

  constexpr bool operator==(const MicroDesign&) const = default;
};

constexpr MicroDesign micro_design(const Figures& figures) {
  return {figures.design, figures.expressions, figures.enable_latch, figures.has_wired_or};
}

/// Row commands of an instruction for subarrays with the given row map; for a global-OR test, the commands until the
/// answer is available.
RowCommands micro_program(const isa::Instruction& instruction, const RowMap& map, const MicroDesign& design);

/// Row commands that clear all pixel memory and the enable bits.
RowCommands clear_program(const RowMap& map, const MicroDesign& design);

/// Row commands that send a field of pixel memory to the host.
RowCommands send_program(isa::Field field);

}  // namespace csgsim::bit_serial_memory
