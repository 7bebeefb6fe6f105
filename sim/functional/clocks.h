// Clocks of a Program that depend on a run of it.
// Used by sim/debug, sim/session, sim/story and sim/studies.
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

/// The record of a run of the whole Program. The Program is run only if its clocks depend on a run; otherwise the
/// record is empty.
machines::RunRecord make_run_record(const isa::Program& program, const machines::Machine& machine);

/// The timing of the Program on the machine, with the host. The Program is run only if its clocks depend on a run.
machines::FrameTiming measure_timing(const isa::Program& program, const machines::Machine& machine);

/// Number of clocks of the Program on the machine. The Program is run only if its clocks depend on a run.
std::uint64_t measure_clocks(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::functional
