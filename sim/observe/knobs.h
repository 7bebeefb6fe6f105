// Measures the worth of changed machine parameters.
// Used by sim/observe and sim/session.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

namespace csgsim::observe {

/// A setting or a machine parameter that was changed to measure its worth.
struct Knob {
  std::string sentence;             ///< description of the change and its worth
  std::string option;               ///< option of csgsim render, as `--machine scan-line+link.width=64`
  std::uint64_t clocks_before = 0;  ///< from one frame to the next
  std::uint64_t clocks_after = 0;   ///< from one frame to the next, with the option
};

/// The clocks before and after, as `262,144 clocks from one frame to the next instead of 362,847, 27.8 % fewer`.
std::string worth(const Knob& knob);

/// Changes each machine parameter that can be improved without another Program by one step, such as twice the width or
/// half the time. The worth is computed from the same instructions with the clock account of the run itself; nothing is
/// drawn or compiled. `word` is the value of --machine. Returns only changes that help, best first.
std::vector<Knob> parameter_knobs(const isa::Program& program, const machines::Machine& machine,
                                  const engine::RunResult& result, const std::string& word);

/// Number of machine parameters that parameter_knobs would try.
std::size_t parameters_to_try(const machines::Machine& machine);

/// Removes changes that do not help, and sorts the rest by clocks.
std::vector<Knob> helpful_knobs(std::vector<Knob> knobs);

}  // namespace csgsim::observe
