// Text form of a Program's row commands.
// Used by the disasm command.
#pragma once

#include <ostream>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// Prints the row commands of a valid Program on a machine of this kind as plain text that other simulators can replay:
/// one command per line (hw/bit_serial_memory/row_command.h), the same for all subarrays; comments begin with `#`.
/// Preceding lines `rows NAME FIRST COUNT` describe the purpose of the rows. Questions are not evaluated: instructions
/// that a skip would omit are included.
void print_row_commands(std::ostream& out, const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::bit_serial_memory
