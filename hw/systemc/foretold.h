// Results of an earlier run, for machines with few pixels.
// Used by hw/pixel_planes, hw/kinds and sim/waves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/plane.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"

namespace csgsim::systemc {

/// Results of an earlier run of the same Program. With them a machine with only some pixels behaves at these like the
/// whole machine. The referenced data must outlive that machine.
struct EarlierRun {
  std::vector<array::Place> pixels;       ///< pixels of the array that are built
  std::vector<bool> answers;              ///< whether any pixel is enabled, for each question in order
  std::span<const machines::Skip> skips;  ///< the questions followed by skipped instructions
  const machines::Timeline* timeline = nullptr;
  std::span<const std::uint32_t> picture;  ///< colour of every pixel of the array after drawing, in row order
};

}  // namespace csgsim::systemc
