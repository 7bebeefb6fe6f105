// Analytic timing of Pixel-planes.
// Used by the Pixel-planes machine and tests.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/timing.h"

namespace csgsim::pixel_planes {

/// Number of register levels of an OR tree over `lines` lines with gates of `fan_in` inputs; 0 if `fan_in` is 0.
std::uint32_t or_levels(std::uint64_t lines, std::uint32_t fan_in);

/// State of the link at the edge at which the controller begins an instruction. Word counts are totals of the frame.
struct Moment {
  std::uint64_t clock = 0;        ///< clock of the frame in which the instruction begins
  std::uint64_t words_read = 0;   ///< words read, including the last word of the instruction
  std::uint64_t words_sent = 0;   ///< words read or in the FIFO
  std::uint32_t clocks_left = 0;  ///< remaining clocks of the next word on the link; 0 if it waits for room
};

/// The link's state when an executed instruction begins, in a frame without a previous picture on display.
Moment instruction_moment(const isa::Program& program, const machines::Machine& machine,
                          std::span<const machines::Skip> skips, std::uint32_t segment, std::uint32_t index);

/// A frame of a sequence, and its skips.
struct DrawnFrame {
  const isa::Program* program = nullptr;
  std::span<const machines::Skip> skips{};
};

/// Timing of frames in sequence; the first is timed as in Kind::time. The interval of a frame is the time until the
/// next frame begins: with two buffers one clock after the frame's picture has been copied, with one buffer one clock
/// after its last row has been latched. The interval of the last frame assumes that another frame follows.
std::vector<machines::FrameTiming> time_sequence(std::span<const DrawnFrame> frames, const machines::Machine& machine);

}  // namespace csgsim::pixel_planes
