// Checks that a machine can run a Program.
// Used by hw/bit_serial_memory, hw/multi_processor, hw/pixel_square, hw/scan_line, sim/cycle, sim/functional,
// sim/reference and sim/story.
#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Throws InputError, with place and advice, if the machine cannot run the Program: the Program tests whether any pixel
/// is enabled but the machine has no global OR; the Program contains squares but the machine's expressions are of
/// degree 1; or a check of the machine's kind fails.
void check_runs_on(const isa::Program& program, const Machine& machine);

/// Used by kinds that draw parts of the picture. Throws InputError unless the Program's segments are the machine's
/// regions and its pixels have no more memory than the machine's.
void check_parts(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
