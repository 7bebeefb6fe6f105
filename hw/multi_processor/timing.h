#pragma once

#include <cstdint>

#include "hw/machines/machine.h"
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

}  // namespace csgsim::multi_processor
