// Measures the worth of changed machine parameters.
// Used by sim/observe and sim/session.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"
#include "sim/engine/engine.h"

namespace csgsim::observe {

/// Clocks from one frame to the next if the same frame is drawn repeatedly.
struct FrameClocks {
  std::uint64_t interval = 0;  ///< clocks of the machine, if its host keeps up
  std::uint64_t hosted = 0;    ///< clocks of the machine, also limited by its host

  bool operator==(const FrameClocks&) const = default;
};

/// The clocks from one frame to the next that result from the timing of a frame.
FrameClocks frame_clocks(const machines::FrameTiming& timing);

/// A setting or a machine parameter that was changed to measure its worth.
struct Knob {
  std::string option;    ///< option of csgsim render, as `--machine scan-line+link.width=64`
  std::string sentence;  ///< description of the change, its worth and its side effect
  std::string worth;     ///< text of the gain, from worth()
  FrameClocks before;
  FrameClocks after;  ///< with the option
};

/// The gain of a change per frame, as `1.82 s per frame with the host instead of 24.7 s (92.6 % less)`. A change that
/// gains nothing with the host states its gain without it.
std::string worth(const FrameClocks& before, const FrameClocks& after, std::uint64_t clock_hz);

/// Changes each machine parameter that can be improved without another Program by one step, such as twice the width,
/// half the time or another processor as host. The worth is computed from the same instructions with the clock account
/// of the run itself; nothing is drawn or compiled. `machine_option` is the value of --machine. Returns only changes
/// that help, best first.
std::vector<Knob> parameter_knobs(const isa::Program& program, const machines::Machine& machine,
                                  const engine::RunResult& result, const std::string& machine_option);

/// Number of machine parameters that parameter_knobs would try.
std::size_t parameters_to_try(const machines::Machine& machine);

/// Removes changes that reduce neither the clocks with the host nor, if those are unchanged, the clocks without it;
/// sorts the rest by the clocks with the host, then without.
std::vector<Knob> helpful_knobs(std::vector<Knob> knobs);

/// The best of several alternatives of one setting; empty if none helps.
std::vector<Knob> best_knob(std::vector<Knob> knobs);

}  // namespace csgsim::observe
