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

/// Commands that a renderer receives for a square: SegmentStart, the instructions, SegmentEnd; empty if the square has
/// no instructions. `skips`: skips of the run, in program order. `timeline`: null, or a blank timeline that the
/// renderers fill.
std::vector<TimedCommand> timed_commands(const isa::Program& program, std::size_t square,
                                         const machines::Machine& machine, std::span<const machines::Skip> skips,
                                         machines::Timeline* timeline);

}  // namespace csgsim::pixel_square
