#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"

namespace csgsim::functional {

/// Whether any instruction may leave out others.
bool may_skip(const isa::Program& program);

/// Whether only a run of the Program on the machine tells its clocks.
bool asks_for_run(const isa::Program& program, const machines::Machine& machine);

/// What a run of the whole Program tells; it is run where that is asked for only.
machines::RunRecord record_of_run(const isa::Program& program, const machines::Machine& machine);

/// Clocks that the Program takes on the machine, for which it is run where only a run tells them.
std::uint64_t clocks_of_run(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::functional
