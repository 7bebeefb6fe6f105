#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// The clocks of a frame and what they went into.
struct FrameTiming {
  std::uint64_t clocks = 0;
  Account account;

  bool operator==(const FrameTiming&) const = default;
};

/// Of any kind.
FrameTiming time_frame(const isa::Program& program, const Machine& machine);

/// Of a machine that holds the whole picture: its instructions follow back to back.
FrameTiming time_whole(const isa::Program& program, const Machine& machine);

/// Least clocks from a mark's entry into a chain of a scan-line array to the next mark's. A line's cells hold their
/// colours from the clock in which the mark is in them until the refresh path takes the line, as many clocks after the
/// mark's entry as the line has pixels; and as many clocks later the path is free for the next line.
constexpr std::uint64_t mark_spacing(std::uint32_t line_pixels) { return line_pixels; }

/// Clocks that the refresh gives to each line of a picture so high, times the chains that share the lines.
std::uint64_t line_budget(const Machine& machine, std::uint32_t picture_height);

/// Of a scan-line array: worked out from the packets of each line (hw/scan_line counts the same).
FrameTiming time_lines(const isa::Program& program, const Machine& machine);

/// Of a pixel-square machine: worked out from the clocks of each instruction (hw/pixel_square counts the same).
FrameTiming time_squares(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
