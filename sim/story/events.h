// Splits a pixel's run into events and surfaces.
// Used by attempts.cpp and story.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/story/pixel_run.h"
#include "sim/story/story.h"

namespace csgsim::story {

/// The events of a pixel's run, without clocks; `first_instruction_numbers` comes from isa::first_instruction_numbers.
/// The result omits stretches that neither find the pixel enabled nor write its memory, skip instructions that skip
/// nothing, and combinations of results that change nothing.
std::vector<Event> find_events(const isa::Program& program, const PixelRun& run,
                               std::span<const std::uint64_t> first_instruction_numbers);

/// The surfaces among the events, and how each ended. `owner` is the pixel's final owner.
std::vector<Attempt> find_attempts(const isa::Program& program, std::span<const Event> events, std::uint32_t owner);

}  // namespace csgsim::story
