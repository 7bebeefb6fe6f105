#pragma once

#include <span>

#include "hw/systemc/wave_request.h"
#include "sim/engine/engine.h"

namespace csgsim::sim {

struct RecordedRun {
  RunResult result;
  bool window_reached = false;  ///< the run was long enough for the file to be written
};

/// Runs the Program on the clocked machine, as make_cycle_engine's does, and writes the requested window of clocks as a
/// VCD file. Throws std::invalid_argument for a probe or field outside the array, InputError for a machine
/// without waves or a file that cannot be opened.
RecordedRun run_and_record(const machines::Machine& machine, const isa::Program& program,
                           std::span<Observer* const> observers, const kernel::WaveRequest& request);

}  // namespace csgsim::sim
