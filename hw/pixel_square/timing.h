#pragma once

#include <cstdint>
#include <span>

#include "hw/machines/machine.h"
#include "hw/machines/timing.h"
#include "hw/pixel_square/account.h"

namespace csgsim::pixel_square {

struct SquareTiming {
  std::uint64_t clocks = 0;
  SquareAccount account;
};

/// Computes the timing of a frame from the clocks of each instruction; the clocked modules must count the same clocks.
/// `skips`: all skips that occurred in the run, in program order.
SquareTiming time_squares(const isa::Program& program, const machines::Machine& machine,
                          std::span<const machines::Skip> skips = {});

}  // namespace csgsim::pixel_square
