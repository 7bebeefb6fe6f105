#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/story/pixel_run.h"
#include "sim/story/story.h"

namespace csgsim::story {

/// The events of a pixel's run; `first_numbers`: isa::first_numbers. Clocks are left empty.
/// Stretches that neither met the pixel enabled nor wrote to its memory are no events, nor are those of questions that
/// skip nothing, and combinations of results that change nothing.
std::vector<Event> events_of(const isa::Program& program, const PixelRun& run,
                             std::span<const std::uint64_t> first_numbers);

/// The surfaces among the events, and how each ended. `owner` of the pixel in the end.
std::vector<Attempt> attempts_of(const isa::Program& program, std::span<const Event> events, std::uint32_t owner);

}  // namespace csgsim::story
