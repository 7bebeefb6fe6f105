#pragma once

#include <ostream>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// The row commands of a Program, which has to be valid, on a machine of this kind, as plain text that other simulators
/// can replay: a line a command (hw/bit_serial_memory/row_command.h), in which subarrays are told the same; comments
/// begin with `#`. Before them lines `rows NAME FIRST COUNT` say what a row is for. Questions are not answered: what a
/// skip leaves out is there.
void print_row_commands(std::ostream& out, const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::bit_serial_memory
