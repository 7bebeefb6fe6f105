#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"

namespace csgsim::functional {

/// Whether any instruction may leave out others.
bool may_skip(const isa::Program& program);

/// What a run of the whole Program skips.
std::vector<machines::Skip> skips_of_run(const isa::Program& program, const machines::Machine& machine);

/// Clocks that the Program takes on the machine. Where instructions may be skipped, it is run to find them.
std::uint64_t clocks_of_run(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::functional
