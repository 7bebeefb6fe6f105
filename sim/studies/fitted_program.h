// Programs compiled for the smallest sufficient pixel memory, and their timing.
// Used by the studies that compare machines and designs.
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

/// A Program and the machine with exactly the memory bits per pixel that it uses.
struct FittedProgram {
  isa::Program program;
  machines::Machine machine;
};

/// Memory bits per pixel to compile with.
struct MemoryGuess {
  std::uint32_t likely = 0;       ///< expected number of bits used; 0 if unknown
  std::uint32_t upper_bound = 0;  ///< maximum number of bits; more are an error
};

/// Compiles for the machine with exactly the memory bits that the Program uses. A correct guess saves time and does not
/// change the result. Neither strategy nor colouring may be automatic, because automatic choices depend on the
/// available memory. Throws InputError if the model does not fit into guess.upper_bound bits.
FittedProgram compile_with_least_memory(const model::Tree& tree, const facet::Geometry& scene, const view::View& view,
                                        machines::Machine machine, const emit::Options& options,
                                        const MemoryGuess& guess);

/// Computes the timing of runs. The skipped parts of a Program and the pixels that its instructions affect depend only
/// on its instructions, not on the machine's clocks. Programs with the same instructions are therefore run once for all
/// machines that request the same kind of record. Thread-safe.
class RunTimer {
 public:
  /// The timing of a run of the Program on the machine.
  machines::FrameTiming time(const isa::Program& program, const machines::Machine& machine);

  /// The run-time outcome that exact timing needs; empty if the timing needs no run.
  machines::RunOutcome outcome(const isa::Program& program, const machines::Machine& machine);

 private:
  Memo<std::vector<std::uint64_t>, machines::RunRecord> runs_;  ///< keyed by hashes of the segments
};

}  // namespace csgsim::studies
