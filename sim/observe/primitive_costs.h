// The most expensive primitives of a frame.
// Used by sim/observe, sim/report, sim/shell and sim/studies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"

namespace csgsim::observe {

/// Cost of a primitive in a frame, without effects.
struct PrimitiveCost {
  std::uint32_t primitive = 0;   ///< index of the primitive
  std::string name;              ///< name in the Program, `cylinder@9:9`
  std::string source;            ///< position in the model's file, `9:9`; empty if the name has none
  std::uint64_t clocks = 0;      ///< clocks of its instructions, in all segments
  double share = 0;              ///< fraction of ClockShares::whole
  std::uint32_t pieces = 0;      ///< number of convex pieces it is drawn as
  std::uint64_t halfspaces = 0;  ///< half-spaces scan-converted for its surface, after pruning
};

struct EffectCost {
  std::string name;
  std::uint64_t clocks = 0;
};

/// Distribution of a frame's clocks. Primitives, effects and the rest add up to the whole.
struct ClockShares {
  std::vector<PrimitiveCost>
      most_expensive;  ///< most expensive first, at most `max_listed_primitives`; only primitives with clocks
  std::uint64_t other_primitives = 0;  ///< number of further primitives with clocks
  std::uint64_t other_clocks = 0;      ///< clocks of these
  std::vector<EffectCost> effects;     ///< effects with clocks, except flat shading, which counts for the primitives
  std::uint64_t rest = 0;              ///< clocks for no primitive: clearing the frame, and the final latency
  std::uint64_t whole = 0;             ///< clocks of all instructions, over all segments, and the final latency
};

inline constexpr std::size_t max_listed_primitives = 10;

/// Distributes the clocks of the run with these stats.
ClockShares clock_shares(const isa::Program& program, const engine::RunResult& result, const Stats& stats);

/// The position in the model's file that a primitive's name contains, `9:9` of `cylinder@9:9`; empty if there is none.
std::string source_position(const std::string& primitive_name);

/// Number of visible pixels of each primitive of the Program.
std::vector<std::uint64_t> visible_pixel_counts(const Frame& frame, const isa::Program& program);

}  // namespace csgsim::observe
