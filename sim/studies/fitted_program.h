#pragma once

#include <cstdint>
#include <vector>

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"
#include "sim/studies/memo.h"

namespace csgsim::studies {

/// A Program, and the machine with just as many memory bits a pixel as it takes.
struct Fitted {
  isa::Program program;
  machines::Machine machine;
};

/// Memory bits a pixel to compile with.
struct MemoryGuess {
  std::uint32_t likely = 0;  ///< that the Program takes; 0 if nobody knows
  std::uint32_t most = 0;    ///< that it may take
};

/// Compiles for the machine with just as many memory bits as the Program takes then. A right guess saves time and
/// changes nothing. Neither strategy nor colouring may be automatic: what they choose depends on the memory at hand.
/// Throws InputError where the model does not fit the most.
Fitted compile_fitting(const model::Tree& tree, const facet::Geometry& scene, const view::View& view,
                       machines::Machine machine, const emit::Options& options, const MemoryGuess& guess);

/// Tells what runs take. What of a Program is skipped, and which pixels its instructions meet, depends on these alone,
/// not on the machine's clocks: Programs with the same instructions are run once, on whatever machines that ask for the
/// same. Several threads may ask at the same time.
class RunTimer {
 public:
  /// As a run of the Program on the machine tells it.
  machines::FrameTiming time(const isa::Program& program, const machines::Machine& machine);

  /// What that run tells; it is there as long as the timer.
  machines::Told told(const isa::Program& program, const machines::Machine& machine);

 private:
  Memo<std::vector<std::uint64_t>, machines::RunRecord> runs_;  ///< by hashes of the segments
};

}  // namespace csgsim::studies
