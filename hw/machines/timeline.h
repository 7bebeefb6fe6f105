// Clocks of each instruction of a frame.
// Used by hw/multi_processor, hw/pixel_square, hw/scan_line, hw/systemc, sim/debug, sim/story and sim/waves.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"

namespace csgsim::machines {

/// A range of clocks of a frame; `end` is the first clock after it. Clock 0 begins with the first rising edge after the
/// frame was requested.
struct ClockSpan {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  [[nodiscard]] constexpr bool empty() const { return begin == end; }
  constexpr bool operator==(const ClockSpan&) const = default;
};

/// Clocks in which the instructions of a frame are executed.
struct Timeline {
  /// For each instruction of each segment: the clocks in which its steps leave the unit that issues them, a controller
  /// or the entry of a chain. For a global-OR test this includes the clocks until its result arrives. The span of a
  /// skipped instruction is empty and begins at 0.
  std::vector<std::vector<ClockSpan>> issued;

  /// For each segment: the clocks in which memory and enable of its pixels are cleared.
  std::vector<ClockSpan> cleared;

  /// Pixel activity from which the timeline was computed, for kinds that need it.
  std::vector<PixelActivity> pixel_activity{};
};

/// The timeline of a frame, computed without stepping. `outcome`: as for time_frame(). Throws InputError for a kind
/// that does not support timelines.
Timeline timeline(const isa::Program& program, const Machine& machine, const RunOutcome& outcome = {});

/// For each instruction of a segment: the clocks in which pixel (x, y) of the picture, which must lie in the segment's
/// region, executes it. Its effects are visible from the span's `end` on. `timeline` must belong to the Program and the
/// machine. The span of a skipped instruction is empty and begins at 0.
std::vector<ClockSpan> spans_at_pixel(const Timeline& timeline, const isa::Program& program, const Machine& machine,
                                      std::uint32_t segment, std::uint32_t x, std::uint32_t y);

/// A timeline with an empty span for each instruction and segment.
Timeline blank_timeline(const isa::Program& program);

/// The spans shifted by `clocks`, except the empty spans of skipped instructions.
std::vector<ClockSpan> shifted(std::vector<ClockSpan> spans, std::uint64_t clocks);

}  // namespace csgsim::machines
