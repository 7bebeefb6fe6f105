#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"
#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// What a renderer is told of a square: SegmentStart, its instructions, SegmentEnd; nothing without instructions.
/// `skips`: of the run, in program order. `told`, unless null, is a blank timeline, which the renderers fill.
std::vector<TimedCommand> timed_commands(const isa::Program& program, std::size_t square,
                                         const machines::Machine& machine, std::span<const machines::Skip> skips,
                                         machines::Timeline* told);

}  // namespace csgsim::pixel_square
