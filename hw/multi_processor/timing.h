#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/told.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/clocks.h"

namespace csgsim::multi_processor {

/// Throws InputError for a Program without a display model, where that, a segment's half-spaces and a few instructions
/// do not fit the memory of the display processor or of a node, and where a frame takes longer than is simulated.
void check_fits(const isa::Program& program, const machines::Machine& machine);

struct FrameClocks {
  std::uint64_t clocks = 0;
  FrameAccount account;
};

/// Worked out stage by stage (the modules count the same). `met`: as machines::Told; without it, where nodes branch, a
/// bound.
FrameClocks time_stages(const isa::Program& program, const machines::Machine& machine,
                        std::span<const machines::MetPixels> met = {});

/// Part of a subsegment's list, and the clocks of the frame from when the nodes begin to render it until the slowest
/// has.
struct BegunPart {
  ListPart part;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

/// A subsegment's, in order. `met`: as time_stages, which has to live as long as they do.
std::vector<BegunPart> begun_parts(const isa::Program& program, const machines::Machine& machine, std::uint32_t segment,
                                   std::span<const machines::MetPixels> met = {});

}  // namespace csgsim::multi_processor
