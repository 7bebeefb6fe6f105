#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Throws InputError, which says where and what to do, if the machine cannot run the Program: it asks whether any pixel
/// is enabled, and the machine has no global OR; it has squares, and the machine's expressions are of degree 1; or what
/// its kind checks.
void check_runs_on(const isa::Program& program, const Machine& machine);

/// For kinds that work on parts of the picture: throws InputError unless the Program's segments are the machine's
/// regions and its pixels have no more memory than the machine's.
void check_parts(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
