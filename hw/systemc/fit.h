#pragma once

#include "hw/isa/program.h"

namespace csgsim::systemc {

/// Throws InputError unless the machine has the pixels and memory bits that the Program is for.
void check_fits(const isa::ArrayShape& program, const isa::ArrayShape& machine);

}  // namespace csgsim::systemc
