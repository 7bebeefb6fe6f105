#pragma once

#include <cstdint>
#include <span>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"
#include "hw/processors/operations.h"

namespace csgsim::host {

/// What the machine's host does for a frame: of a machine that divides the model itself, it makes that; else it
/// compiles every segment.
processors::Operations operations_of(const isa::Program& program, const machines::Machine& machine);

/// Clocks of the machine in which its host does that, rounded up; 0 for an ideal one. Throws InputError where they are
/// more than can be told.
std::uint64_t compile_clocks(const isa::Program& program, const machines::Machine& machine);

/// The same frame with its host, and with_pace.
machines::FrameTiming with_host(machines::FrameTiming timing, const isa::Program& program,
                                const machines::Machine& machine);

/// As machines::time_frame, with the host.
machines::FrameTiming time_frame(const isa::Program& program, const machines::Machine& machine,
                                 const machines::Told& told = {});

}  // namespace csgsim::host
