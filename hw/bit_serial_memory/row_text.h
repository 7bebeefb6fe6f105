// Text form of a Program's row commands.
// Used by sim/app and sim/rows.
#pragma once

#include <ostream>

#include "hw/bit_serial_memory/row_map.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// Prints the purpose of a subarray's rows: lines `rows NAME FIRST COUNT`.
void print_row_map(std::ostream& out, const RowMap& map);

/// Prints the row commands of a valid Program on a machine of this kind as plain text that other simulators can replay:
/// one command per line (hw/bit_serial_memory/row_command.h), the same for all subarrays; comments begin with `#`.
/// Lines `rows NAME FIRST COUNT` at the beginning describe the purpose of the rows. Global-OR tests are not evaluated:
/// instructions that may be skipped are included.
void print_row_commands(std::ostream& out, const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::bit_serial_memory
