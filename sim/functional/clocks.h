// Clocks of a Program that depend on a run of it.
// Used by sessions, debug, story and studies.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"

namespace csgsim::functional {

/// Whether any instruction may skip others.
bool may_skip(const isa::Program& program);

/// Whether the clocks on that machine can only be found by running the Program.
bool needs_run(const isa::Program& program, const machines::Machine& machine);

/// The record of a run of the whole Program, which is only run if its clocks depend on it.
machines::RunRecord make_run_record(const isa::Program& program, const machines::Machine& machine);

/// The timing of the Program on the machine, with the host. It is only run if the clocks depend on it.
machines::FrameTiming measure_timing(const isa::Program& program, const machines::Machine& machine);

/// The number of clocks that the Program takes on the machine. It is only run if the clocks depend on it.
std::uint64_t measure_clocks(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::functional
