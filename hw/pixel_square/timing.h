#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"
#include "hw/pixel_square/account.h"

namespace csgsim::pixel_square {

struct SquareTiming {
  std::uint64_t clocks = 0;
  SquareAccount account;
};

/// Worked out from the clocks of each instruction (the modules count the same).
SquareTiming time_squares(const isa::Program& program, const machines::Machine& machine);

machines::FrameTiming time_frame(const isa::Program& program, const machines::Machine& machine,
                                 std::span<const machines::Skip> skips);

/// When the controller of the renderer that draws the square has an instruction's steps on its wires; they come to all
/// of its pixels at once, through the levels of its trees.
machines::Timeline timeline(const isa::Program& program, const machines::Machine& machine,
                            std::span<const machines::Skip> skips);
std::vector<machines::ClockSpan> at_pixel(const machines::Timeline& timeline, const isa::Program& program,
                                          const machines::Machine& machine, std::uint32_t segment, std::uint32_t x,
                                          std::uint32_t y);

}  // namespace csgsim::pixel_square
