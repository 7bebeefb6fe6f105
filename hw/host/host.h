// Work and clocks of the host for a frame.
// Used by sim.
#pragma once

#include <cstdint>
#include <span>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"
#include "hw/processors/operations.h"

namespace csgsim::host {

/// Work of the machine's host for a frame. The host prepares the display model for a machine that divides the model
/// itself, and otherwise compiles every segment.
processors::Operations count_operations(const isa::Program& program, const machines::Machine& machine);

/// Nanoseconds that the machine's host takes for the operations, which its processors share; 0 for an ideal host.
double nanoseconds(const processors::Operations& operations, const machines::Machine& machine);

/// Clocks of the machine until its host has finished a frame, rounded up; 0 for an ideal host. Throws InputError above
/// 9e15.
std::uint64_t compile_clocks(const isa::Program& program, const machines::Machine& machine);

/// Clocks of the machine until its host has done the work on the model, which precedes the first frame; rounded up, 0
/// for an ideal host. Throws InputError above 9e15.
std::uint64_t model_clocks(const isa::Program& program, const machines::Machine& machine);

/// Returns `timing` with the host's clocks set, completed by machines::with_pace().
machines::FrameTiming with_host(machines::FrameTiming timing, const isa::Program& program,
                                const machines::Machine& machine);

/// The timing of machines::time_frame(), completed by with_host().
machines::FrameTiming time_frame(const isa::Program& program, const machines::Machine& machine,
                                 const machines::RunOutcome& outcome = {});

}  // namespace csgsim::host
