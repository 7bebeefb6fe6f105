// Results of a functional run that waveform recording needs.
// Used by sim/waves and sim/app.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"
#include "sim/engine/engine.h"

namespace csgsim::waves {

/// Results of a run at the functional level, needed before a waveform is recorded.
struct Foreknowledge {
  engine::RunResult result;
  std::vector<bool> answers;           ///< result of each global OR in order: whether any pixel is enabled
  std::vector<std::uint32_t> picture;  ///< pixels in row order, for a Program of one segment with colours
  machines::Timeline timeline;
};

/// Runs the Program at the functional level. Throws InputError like the engine, and for kinds of machines without a
/// timeline.
Foreknowledge gather_foreknowledge(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::waves
