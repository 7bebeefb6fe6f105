#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// Clocks of a divider's tests before the commands of a square with these counts can leave; 0 where the host divides.
std::uint64_t test_clocks(const isa::DivisionCounts& counts, const Figures& figures);

/// Throws InputError where the divider's tests are too many for their clocks to be counted in 64 bits.
void check_countable(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
