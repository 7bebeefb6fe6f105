#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/timing.h"

namespace csgsim::pixel_planes {

/// Levels of registers of a tree of ORs with that fan-in over so many lines; 0 where the fan-in is 0.
std::uint32_t or_levels(std::uint64_t lines, std::uint32_t fan_in);

/// The link at the edge at which the controller begins an instruction. Words are those of the whole frame.
struct Moment {
  std::uint64_t clock = 0;        ///< of the frame, the instruction's first
  std::uint64_t words_read = 0;   ///< the instruction's own are the last
  std::uint64_t words_sent = 0;   ///< those and the ones in the FIFO
  std::uint32_t clocks_left = 0;  ///< that the next word has still to be on the link; 0 if it waits for room
};

/// Of an instruction that is carried out, in a frame before which none is shown.
Moment moment_of(const isa::Program& program, const machines::Machine& machine, std::span<const machines::Skip> skips,
                 std::uint32_t segment, std::uint32_t index);

/// A frame of a sequence, and what it skips.
struct DrawnFrame {
  const isa::Program* program = nullptr;
  std::span<const machines::Skip> skips{};
};

/// Frames that follow each other, the first as Kind::time has it. The interval of each is that to the next, which
/// begins, with two buffers, in the clock after the one in which the frame's picture has been copied, and with one in
/// the clock after the last row has been latched; that of the last is what it would be if another followed.
std::vector<machines::FrameTiming> time_sequence(std::span<const DrawnFrame> frames, const machines::Machine& machine);

}  // namespace csgsim::pixel_planes
