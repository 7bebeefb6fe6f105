#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Throws InputError, which says where and what to do, if the machine cannot run the Program: it asks whether any pixel
/// is enabled, and the machine has no global OR; or, of a machine that works on parts of the picture, its segments are
/// not the machine's regions, its pixels have more memory, or a count is too large for a frame's clocks to be counted
/// in 64 bits.
void check_runs_on(const isa::Program& program, const Machine& machine);

/// The last of these, for a pixel-square machine.
void check_countable(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
