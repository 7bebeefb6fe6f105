#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"
#include "hw/multi_processor/account.h"

namespace csgsim::multi_processor {

/// Throws InputError for a Program without a display model, where that, a segment's half-spaces and its lists do not
/// fit the memory of the display processor or of a node, and where a frame takes longer than is simulated.
void check_fits(const isa::Program& program, const machines::Machine& machine);

struct FrameClocks {
  std::uint64_t clocks = 0;
  FrameAccount account;
};

/// Worked out stage by stage (the modules count the same).
FrameClocks time_stages(const isa::Program& program, const machines::Machine& machine);

machines::FrameTiming time_frame(const isa::Program& program, const machines::Machine& machine,
                                 std::span<const machines::Skip> skips);

/// When the first node begins with an instruction at its first pixel of the subsegment, until the last is through with
/// its last; and when the node that has a pixel is at that.
machines::Timeline timeline(const isa::Program& program, const machines::Machine& machine,
                            std::span<const machines::Skip> skips);
std::vector<machines::ClockSpan> at_pixel(const machines::Timeline& timeline, const isa::Program& program,
                                          const machines::Machine& machine, std::uint32_t segment, std::uint32_t x,
                                          std::uint32_t y);

}  // namespace csgsim::multi_processor
