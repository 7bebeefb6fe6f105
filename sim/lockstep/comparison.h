// Comparison of two runs in lockstep, and of their pictures.
// Used by sim/app and sim/viewer.
#pragma once

#include <cstdint>
#include <optional>

#include "hw/machines/machine.h"
#include "sim/lockstep/lockstep.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"

namespace csgsim::lockstep {

/// One of the two runs to compare.
struct Side {
  const isa::Program& program;
  const machines::Machine& machine;
  engine::Engine& engine;
};

/// The results of one side.
struct SideResult {
  engine::RunResult result;
  observe::Frame frame;
  observe::Stats stats;
};

/// The first pixel, in row order, that differs between the finished pictures.
struct PictureDifference {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint64_t pixels = 0;  ///< number of differing pixels
};

/// The result of comparing two runs.
struct Comparison {
  /// Number of the first instruction that differs between the Programs or exists in only one of them; empty if they are
  /// equal. The origins of instructions (isa::Origin) are ignored.
  std::optional<std::uint64_t> other_instruction;
  std::uint64_t compared = 0;  ///< number of instructions after which the states were compared and equal
  /// Comparison continues past different instructions if both Programs have the same number for each region.
  std::optional<Divergence> divergence;
  std::optional<PictureDifference> picture;
  SideResult a;
  SideResult b;
};

/// Runs both sides in lockstep, alternating by instruction. The pictures must have the same size, and B's engine must
/// be able to pause. Throws InputError if a machine cannot run its Program.
Comparison compare(const Side& a, const Side& b);

/// The number of the first differing instruction, as in Comparison::other_instruction.
std::optional<std::uint64_t> first_different_instruction(const isa::Program& a, const isa::Program& b);

/// The first difference between two pictures of the same size.
std::optional<PictureDifference> first_difference(const observe::Frame& a, const observe::Frame& b);

}  // namespace csgsim::lockstep
