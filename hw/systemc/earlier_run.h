// Results of an earlier run, for machines with few pixels.
// Used by hw/systemc, hw/pixel_planes and hw/kinds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/plane.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"

namespace csgsim::systemc {

/// Results of an earlier run of the same Program. With these results, a machine of which only some pixels are simulated
/// behaves at these pixels like the whole machine. The referenced data must outlive that machine.
struct EarlierRun {
  std::vector<array::Place> pixels;       ///< pixels of the array that are simulated
  std::vector<bool> answers;              ///< for each global-OR test in order, whether any pixel was enabled
  std::span<const machines::Skip> skips;  ///< the global-OR tests that caused skips
  const machines::Timeline* timeline = nullptr;
  std::span<const std::uint32_t> picture;  ///< colour of every pixel of the array after drawing, in row order
};

}  // namespace csgsim::systemc
