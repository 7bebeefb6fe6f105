// Histories of selected pixels for a page.
// Used by run_page.cpp and two_page.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/report/page.h"
#include "sim/story/phrases.h"

namespace csgsim::report {

struct StoryLimits {
  std::size_t pixels = 64;
  std::size_t bytes = 400'000;             ///< all texts together
  std::uint64_t instructions = 4'000'000;  ///< executed for all stories together
};

/// Primitives by their clocks in a run's stats, most expensive first.
std::vector<std::uint32_t> primitives_by_cost(const Json& stats);

/// One pixel for each of these owners that is visible, in their order: the pixel farthest, in rows plus columns, from
/// pixels of other owners and from the border; of several, the middle one in row order. `owner` has the owner of each
/// pixel in row order, `width` pixels per row.
std::vector<std::size_t> central_pixels(std::span<const std::uint32_t> owner, std::size_t width,
                                        std::span<const std::uint32_t> owners);

/// Adds the histories of these pixels, numbered in row order, to the drawing until a limit is reached; the first one is
/// always added. The machine must be able to run the Program.
void add_stories(const story::Subject& subject, const machines::Machine& machine, std::span<const std::size_t> pixels,
                 Drawing& drawing, const StoryLimits& limits = {});

}  // namespace csgsim::report
