#include "tests/performance/program_work.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <span>

#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"
#include "sim/functional/stretch.h"
#include "sim/functional/tile.h"
#include "sim/observe/frame.h"

namespace csgsim::bench {

namespace {

/// The contribution of each instruction of a stretch to a tile's share.
std::vector<TileShare> shares_of(std::span<const isa::Instruction> instructions, const machines::Machine& machine) {
  std::vector<TileShare> shares;
  shares.reserve(instructions.size());
  for (const isa::Instruction& instruction : instructions) {
    const bool linear = isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear);
    shares.push_back({1, linear ? 1U : 0U, 0, machines::bit_serial_clocks(instruction, machine)});
  }
  return shares;
}

std::uint64_t looks_of(const functional::Tile& tile) { return tile.work().words + tile.work().lanes; }

TileShare execute(functional::Tile& tile, const functional::Stretch& stretch, std::span<const TileShare> shares) {
  TileShare all;
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t i = 0;; ++i) {
    if (tile.enabled() == 0) i = stretch.first_acting_from(i);
    if (i == stretch.size()) break;
    const std::uint64_t looked_at = looks_of(tile);
    tile.execute(stretch.instructions()[i]);
    if (looks_of(tile) != looked_at) ++all.open;
    all.instructions += shares[i].instructions;
    all.linear += shares[i].linear;
    all.steps += shares[i].steps;
  }
  all.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return all;
}

std::vector<functional::Tile> tiles_of(const isa::Region& region, std::uint32_t memory_bits) {
  using functional::tile_side;
  std::vector<functional::Tile> tiles;
  for (std::uint32_t y = 0; y < region.height; y += tile_side) {
    for (std::uint32_t x = 0; x < region.width; x += tile_side) {
      const functional::TileShape shape(std::min(tile_side, region.width - x), std::min(tile_side, region.height - y));
      tiles.emplace_back(x, y, shape, memory_bits, functional::Decide::by_block);
    }
  }
  return tiles;
}

std::uint64_t enabled_in(std::span<const functional::Tile> tiles) {
  std::uint64_t enabled = 0;
  for (const functional::Tile& tile : tiles) enabled += tile.enabled();
  return enabled;
}

/// Adds the segment's stretches to the replay. Observers are asked where stretches end, but receive no states.
void replay_segment(const isa::Program& program, std::uint32_t number, const machines::Machine& machine,
                    std::span<engine::Observer* const> observers, Replay& out) {
  const std::span instructions(program.segments[number].instructions);
  std::vector<functional::Tile> tiles = tiles_of(program.segments[number].region, program.shape.memory_bits);
  for (std::size_t index = 0; index < instructions.size();) {
    const functional::Stretch stretch(instructions.subspan(index), observers);
    const std::vector<TileShare> shares = shares_of(stretch.instructions(), machine);
    StretchShares& shared = out.stretches.emplace_back(StretchShares{number, {}});
    for (functional::Tile& tile : tiles) shared.tiles.push_back(execute(tile, stretch, shares));
    index += stretch.size() + isa::skipped_instruction_count(stretch.instructions().back(), enabled_in(tiles));
  }
  for (const functional::Tile& tile : tiles) out.work += tile.work();
}

template <class Number>
std::uint64_t most(const StretchShares& stretch, Number number) {
  std::uint64_t most = 0;
  for (const TileShare& tile : stretch.tiles) most = std::max(most, tile.*number);
  return most;
}

}  // namespace

Replay replay(const isa::Program& program, const machines::Machine& machine) {
  observe::FrameObserver frame(program);
  const std::array<engine::Observer*, 1> observers{&frame};
  Replay all;
  for (std::uint32_t number = 0; number < program.segments.size(); ++number)
    replay_segment(program, number, machine, observers, all);
  return all;
}

ProgramWork work_of(const isa::Program& program, const Replay& replay) {
  ProgramWork all{program.segments.size(), replay.stretches.size(), 0, replay.work};
  for (const isa::Segment& segment : program.segments) {
    const auto along = [](std::uint32_t pixels) {
      return (pixels + functional::tile_side - 1) / functional::tile_side;
    };
    all.tiles += std::uint64_t{along(segment.region.width)} * along(segment.region.height);
  }
  for (const StretchShares& stretch : replay.stretches) {
    for (const TileShare& tile : stretch.tiles) {
      all.linear += tile.linear;
      all.steps += tile.steps;
      all.open += tile.open;
    }
    all.longest += most(stretch, &TileShare::instructions);
    all.longest_steps += most(stretch, &TileShare::steps);
    all.longest_open += most(stretch, &TileShare::open);
  }
  return all;
}

}  // namespace csgsim::bench
