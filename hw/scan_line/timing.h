#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/scan_line/account.h"

namespace csgsim::scan_line {

/// Number of words of an instruction's packet: those of its widest operand, at least one. For an expression delivered
/// by trees, its width divided by the bits delivered per clock.
std::uint64_t packet_words(const isa::Instruction& instruction, const machines::Machine& machine);

/// Minimum clocks between the entries of the last beats of two marks into a chain. A line's cells hold their colours
/// from the clock in which that beat is in them until the refresh path takes the line, which is one clock per pixel of
/// the line after the beat's entry. After the same number of further clocks, the path is free for the next line.
constexpr std::uint64_t mark_spacing(std::uint32_t line_pixels) { return line_pixels; }

/// Clocks that the refresh allows for a line of a picture of the given height: its time per line times the number of
/// chains.
std::uint64_t line_budget(const machines::Machine& machine, std::uint32_t picture_height);

struct LineTiming {
  std::uint64_t clocks = 0;
  /// Clocks from the beginning of the frame to that of the next: the host begins a frame when the last mark of the
  /// previous frame has entered.
  std::uint64_t interval_clocks = 0;
  LineAccount account;
};

/// Computes the timing of a frame on an idle machine from the words and packets of each line; the clocked modules must
/// count the same clocks. The interval is that of drawing the same frame repeatedly. `timeline`: null, or a blank
/// timeline to fill.
LineTiming time_lines(const isa::Program& program, const machines::Machine& machine,
                      machines::Timeline* timeline = nullptr);

/// Computes the timing of consecutive frames, all of equal width.
std::vector<LineTiming> time_line_sequence(std::span<const isa::Program> frames, const machines::Machine& machine);

}  // namespace csgsim::scan_line
