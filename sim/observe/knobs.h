#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/engine/engine.h"

namespace csgsim::observe {

/// A setting, or a figure of the machine, that was changed to see what it is worth.
struct Knob {
  std::string sentence;             ///< for people: what was changed, and what that was worth
  std::string option;               ///< of csgsim render, as `--machine scan-line+link.width=64`
  std::uint64_t clocks_before = 0;  ///< from one frame to the next
  std::uint64_t clocks_after = 0;   ///< the same, with the option
};

/// The clocks before and after, as `262,144 clocks from one frame to the next instead of 362,847: 27.8 % fewer`.
std::string worth(const Knob& knob);

/// The machine's figures that can be bettered without another Program, one after the other, each by one step: twice as
/// wide, half as long. What it is worth is worked out from the same instructions, by the account of clocks that the run
/// itself is timed with: nothing is drawn or compiled. `word`: what --machine was given. Only those that help, the one
/// that helps most first.
std::vector<Knob> figure_knobs(const isa::Program& program, const machines::Machine& machine,
                               const engine::RunResult& result, const std::string& word);

/// How many figures of the machine that would try.
std::size_t figures_to_try(const machines::Machine& machine);

/// The clocks after, the fewest first; what does not help is left out.
std::vector<Knob> that_help(std::vector<Knob> knobs);

}  // namespace csgsim::observe
