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

/// What a primitive takes of a frame, without the effects.
struct PrimitiveCost {
  std::uint32_t primitive = 0;   ///< its index
  std::string name;              ///< as the Program has it, `cylinder@9:9`
  std::string source;            ///< its place in the model's file, `9:9`; empty if the name tells none
  std::uint64_t clocks = 0;      ///< of its instructions, in all segments
  double share = 0;              ///< of ClockShares::whole
  std::uint32_t pieces = 0;      ///< convex ones that it is drawn as
  std::uint64_t halfspaces = 0;  ///< that are scan-converted for its surface: what pruning leaves of it
};

struct EffectCost {
  std::string name;
  std::uint64_t clocks = 0;
};

/// Where a frame's clocks went. The primitives, the effects and the rest add up to the whole.
struct ClockShares {
  std::vector<PrimitiveCost> dearest;  ///< the dearest first, at most `most_dearest`, of those that take any clocks
  std::uint64_t other_primitives = 0;  ///< how many more take clocks
  std::uint64_t other_clocks = 0;      ///< of these
  std::vector<EffectCost> effects;     ///< that take any, but for flat shading, which is the primitives'
  std::uint64_t rest = 0;              ///< of no primitive: clearing the frame, and what the last step is on its way
  std::uint64_t whole = 0;             ///< clocks of all instructions, over all segments, and the final latency
};

inline constexpr std::size_t most_dearest = 10;

ClockShares clock_shares(const isa::Program& program, const engine::RunResult& result, const Stats& stats);

/// The place in a primitive's name; empty if there is none.
std::string source_of(const std::string& name);

/// Pixels of the picture in which each primitive of the Program is seen.
std::vector<std::uint64_t> pixels_seen(const Frame& frame, const isa::Program& program);

}  // namespace csgsim::observe
