#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/scan_line/account.h"

namespace csgsim::scan_line {

/// Words of an instruction's packet: as many as its widest operand has, one at least; of an expression that comes
/// through trees as many as it has of what these bring in a clock.
std::uint64_t packet_words(const isa::Instruction& instruction, const machines::Machine& machine);

/// Least clocks from the entry of a mark's last beat into a chain to that of the next mark's. A line's cells hold their
/// colours from the clock in which that beat is in them until the refresh path takes the line, as many clocks after its
/// entry as the line has pixels; and as many clocks later the path is free for the next line.
constexpr std::uint64_t mark_spacing(std::uint32_t line_pixels) { return line_pixels; }

/// Clocks that the refresh gives to each line of a picture so high, times the chains that share the lines.
std::uint64_t line_budget(const machines::Machine& machine, std::uint32_t picture_height);

struct LineTiming {
  std::uint64_t clocks = 0;
  /// From one frame to the next: the host begins it when the last mark has entered.
  std::uint64_t interval_clocks = 0;
  LineAccount account;
};

/// Of a frame before which nothing has been drawn, worked out from the words and packets of each line (the modules
/// count the same); the interval where the same is drawn again and again. `told`, unless null, is a blank timeline, and
/// becomes that of the frame.
LineTiming time_lines(const isa::Program& program, const machines::Machine& machine,
                      machines::Timeline* told = nullptr);

/// The same of frames that follow one another, all of one width.
std::vector<LineTiming> time_line_sequence(std::span<const isa::Program> frames, const machines::Machine& machine);

}  // namespace csgsim::scan_line
