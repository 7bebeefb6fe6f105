#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"
#include "sim/engine/engine.h"

/// Waves of a run: which clocks, and the file.
namespace csgsim::waves {

/// What a run at the functional level tells before a wave is recorded.
struct Foreknowledge {
  engine::RunResult result;
  std::vector<bool> answers;           ///< to each question that is asked, in order: is any pixel enabled?
  std::vector<std::uint32_t> picture;  ///< of a Program of one segment with colours: its pixels', in row order
  machines::Timeline timeline;
};

/// Throws InputError as the engine does, and for a kind of machine that has no timeline.
Foreknowledge foresee(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::waves
