#pragma once

#include "hw/isa/program.h"

namespace csgsim::fuzz {

/// Checks the invariants of a Program: it is valid, and both of its forms are read as the same Program.
void check_program(const isa::Program& program);

}  // namespace csgsim::fuzz
