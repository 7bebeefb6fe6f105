#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/engine/work.h"

namespace csgsim::bench {

/// Work of a tile in a stretch of instructions at the functional level.
struct TileShare {
  std::uint64_t instructions = 0;  ///< number executed
  std::uint64_t linear = 0;        ///< those with a linear expression
  std::uint64_t open = 0;          ///< those that needed words or lanes, not decided by blocks alone
  std::uint64_t steps = 0;         ///< clocks of bit-serial pixel processors for them
  double seconds = 0;
};

/// Threads that share tiles synchronize at the end of each stretch (sim/functional/stretch.h).
struct StretchShares {
  std::uint32_t segment = 0;
  std::vector<TileShare> tiles;
};

/// A Program executed once, on one thread, tile by tile.
struct Replay {
  engine::Work work;
  std::vector<StretchShares> stretches;
};

/// The machine's parameters determine the steps.
Replay replay(const isa::Program& program, const machines::Machine& machine);

/// Work of a Program at the functional level, equal on every computer.
struct ProgramWork {
  std::uint64_t segments = 0;
  std::uint64_t stretches = 0;
  std::uint64_t tiles = 0;          ///< tiles of all segments
  engine::Work work{};              ///< sum over all tiles
  std::uint64_t linear = 0;         ///< instructions at tiles with a linear expression
  std::uint64_t open = 0;           ///< instructions at tiles that needed words or lanes
  std::uint64_t steps = 0;          ///< bit steps of these instructions at all tiles
  std::uint64_t longest = 0;        ///< sum over stretches of the instructions at the busiest tile
  std::uint64_t longest_open = 0;   ///< `open` of the busiest tiles
  std::uint64_t longest_steps = 0;  ///< `steps` of the busiest tiles
};

ProgramWork work_of(const isa::Program& program, const Replay& replay);

}  // namespace csgsim::bench
