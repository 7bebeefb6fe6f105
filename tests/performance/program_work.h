#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/engine/work.h"

namespace csgsim::bench {

/// What a tile of pixels takes in a stretch of instructions at the functional level.
struct TileShare {
  std::uint64_t instructions = 0;  ///< carried out at it
  std::uint64_t linear = 0;        ///< of these, those with a linear expression
  std::uint64_t open = 0;          ///< of these, those that looked at words or lanes: blocks alone did not decide them
  std::uint64_t steps = 0;         ///< clocks that pixel processors that work bit by bit take for them
  double seconds = 0;
};

/// Threads that share out tiles meet at the end of each stretch (sim/functional/stretch.h).
struct StretchShares {
  std::uint32_t segment = 0;
  std::vector<TileShare> tiles;
};

/// A Program carried out once, on one thread, tile by tile.
struct Replay {
  engine::Work work;
  std::vector<StretchShares> stretches;
};

/// The machine's figures say what a step takes.
Replay replay(const isa::Program& program, const machines::Machine& machine);

/// What a Program takes at the functional level. The same on every computer.
struct ProgramWork {
  std::uint64_t segments = 0;
  std::uint64_t stretches = 0;
  std::uint64_t tiles = 0;          ///< of all segments
  engine::Work work{};              ///< over all tiles
  std::uint64_t linear = 0;         ///< of the instructions at tiles, those with a linear expression
  std::uint64_t open = 0;           ///< of the instructions at tiles, those that looked at words or lanes
  std::uint64_t steps = 0;          ///< bit steps of these instructions at all tiles
  std::uint64_t longest = 0;        ///< instructions at the tile that has most of them, of each stretch
  std::uint64_t longest_open = 0;   ///< `open`, likewise
  std::uint64_t longest_steps = 0;  ///< `steps`, likewise
};

ProgramWork work_of(const isa::Program& program, const Replay& replay);

}  // namespace csgsim::bench
