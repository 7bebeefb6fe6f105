#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Throws InputError, which says where and what to do, if the Program asks whether any pixel is enabled and the machine
/// has no global OR.
void require_answers(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
