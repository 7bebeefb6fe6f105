#pragma once

#include <cstddef>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/pixel_square/timing_renderer.h"

namespace csgsim::pixel_square {

/// What a renderer is told of a square: SegmentStart, its instructions, SegmentEnd; nothing without instructions.
/// `told`, unless null, is a blank timeline, which the renderers fill.
std::vector<TimedCommand> timed_commands(const isa::Program& program, std::size_t square,
                                         const machines::Machine& machine, machines::Timeline* told);

}  // namespace csgsim::pixel_square
