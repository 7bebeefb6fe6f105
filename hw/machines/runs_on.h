#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Throws InputError if a machine that works on parts of the picture cannot run the Program: it asks a question, whose
/// answer such a machine has no wire for; a region is larger than the array; or a count is too large for a frame's
/// clocks to be counted in 64 bits. What it says of other machines is nothing.
void check_runs_on(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
