#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timing.h"

namespace csgsim::machines {

/// Clocks of a frame; `end` is the first that no longer belongs to it. Clock 0 begins with the first rising edge after
/// the frame was asked for.
struct ClockSpan {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  [[nodiscard]] constexpr bool empty() const { return begin == end; }
  constexpr bool operator==(const ClockSpan&) const = default;
};

/// When the instructions of a frame are carried out.
struct Timeline {
  /// For each segment, for each of its instructions, the clocks in which its steps leave what hands them out, a
  /// controller or the entry of a chain; of a question, with those until its answer is there. Of an instruction that is
  /// skipped the span is empty, at 0.
  std::vector<std::vector<ClockSpan>> issued;

  /// For each segment, the clocks in which memory and enable of its pixels become 0.
  std::vector<ClockSpan> cleared;

  /// What it was worked out from, of a kind that asks for it.
  std::vector<MetPixels> met{};
};

/// Worked out without stepping. `told`: as for time_frame. Throws InputError for a kind that does not tell.
Timeline timeline(const isa::Program& program, const Machine& machine, const Told& told = {});

/// For each instruction of a segment, the clocks in which pixel (x, y) of the picture, which lies in the segment's
/// region, carries it out: what it changes of the pixel is changed from the span's `end` on. `timeline`: of that
/// Program on that machine. Of an instruction that is skipped the span is empty, at 0.
std::vector<ClockSpan> at_pixel(const Timeline& timeline, const isa::Program& program, const Machine& machine,
                                std::uint32_t segment, std::uint32_t x, std::uint32_t y);

/// For a room that works one out: with a span, empty, for each instruction and each segment.
Timeline blank_timeline(const isa::Program& program);

/// Each span so many clocks later, but for those of instructions that are skipped.
std::vector<ClockSpan> later(std::vector<ClockSpan> spans, std::uint64_t clocks);

}  // namespace csgsim::machines
