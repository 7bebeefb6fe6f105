#pragma once

#include <cstdint>
#include <optional>

#include "hw/machines/machine.h"
#include "sim/lockstep/lockstep.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"

namespace csgsim::lockstep {

/// One of two runs that are compared.
struct Side {
  const isa::Program& program;
  const machines::Machine& machine;
  engine::Engine& engine;
};

/// What the run of a side left.
struct SideResult {
  engine::RunResult result;
  observe::Frame frame;
  observe::Stats stats;
};

/// The first pixel, in row order, of which the finished pictures show different things.
struct PictureDifference {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint64_t pixels = 0;  ///< that differ
};

/// How two runs compare.
struct Comparison {
  /// Number of the first instruction that is another one in the two Programs, or that only one of them has; none if all
  /// are the same. Whom an instruction serves (isa::Origin) does not matter.
  std::optional<std::uint64_t> other_instruction;
  std::uint64_t compared = 0;  ///< instructions after which the states were compared and equal
  /// After a different instruction the states are compared on if both Programs have as many for each region.
  std::optional<Divergence> divergence;
  std::optional<PictureDifference> picture;
  SideResult a;
  SideResult b;
};

/// Runs both at the same time, an instruction of each in turn. The pictures have to be equally large, and B's level one
/// that can stop. Throws InputError where a machine cannot run its Program.
Comparison compare(const Side& a, const Side& b);

/// The first instruction that differs, as Comparison::other_instruction.
std::optional<std::uint64_t> first_other_instruction(const isa::Program& a, const isa::Program& b);

/// Where two pictures of one size differ.
std::optional<PictureDifference> first_difference(const observe::Frame& a, const observe::Frame& b);

}  // namespace csgsim::lockstep
