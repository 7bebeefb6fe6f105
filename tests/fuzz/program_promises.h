#pragma once

#include "hw/isa/program.h"

namespace csgsim::fuzz {

/// What holds of every Program that was read: it is valid, and both of its forms are read back as the same Program.
void check_program(const isa::Program& program);

}  // namespace csgsim::fuzz
