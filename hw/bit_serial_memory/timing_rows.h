// Row commands of a frame with the clocks at which they are issued.
// Used by timing.cpp and sim/rows.
#pragma once

#include "hw/bit_serial_memory/command_set.h"
#include "hw/bit_serial_memory/row_listener.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/run_outcome.h"
#include "hw/machines/timing.h"

namespace csgsim::bit_serial_memory {

/// Reports every row command of a frame to the listener, scan-out included, and returns the same timing as Kind::time.
/// The machine must be of this kind; `outcomes` are those of the run. `set`, if not null, replaces the gates of a
/// machine with latches; then the timing differs. Throws InputError if the set lacks a gate.
machines::FrameTiming time_rows(const isa::Program& program, const machines::Machine& machine,
                                const machines::RunOutcome& outcomes, RowListener& listener,
                                const CommandSet* set = nullptr);

}  // namespace csgsim::bit_serial_memory
