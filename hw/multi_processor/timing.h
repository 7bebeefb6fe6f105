#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/run_outcome.h"
#include "hw/multi_processor/account.h"
#include "hw/multi_processor/clocks.h"

namespace csgsim::multi_processor {

/// Throws InputError for a Program without a display model; if the model, a segment's half-spaces and a few
/// instructions do not fit the memory of the display processor or of a node; and if a frame takes longer than the
/// simulator supports.
void check_fits(const isa::Program& program, const machines::Machine& machine);

struct FrameClocks {
  std::uint64_t clocks = 0;
  FrameAccount account;
};

/// Computes the timing stage by stage; the clocked modules must count the same clocks. `pixel_activity`: as in
/// machines::RunOutcome; if `pixel_activity` is empty and nodes branch, the result is an upper bound.
FrameClocks time_stages(const isa::Program& program, const machines::Machine& machine,
                        std::span<const machines::PixelActivity> pixel_activity = {});

/// Part of a subsegment's list, and the clocks of the frame from its start on the nodes until the slowest node has
/// rendered it.
struct StartedPart {
  ListPart part;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

/// Parts of the list of subsegment `segment`, in order. `pixel_activity`: as in time_stages; must outlive the result.
std::vector<StartedPart> started_parts(const isa::Program& program, const machines::Machine& machine,
                                       std::uint32_t segment,
                                       std::span<const machines::PixelActivity> pixel_activity = {});

}  // namespace csgsim::multi_processor
