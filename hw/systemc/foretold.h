#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/plane.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"

namespace csgsim::systemc {

/// What another run of the same Program has told, so that a machine of which only some pixels are built does at these
/// what the whole one does. What it refers to has to live as long as that machine.
struct Foretold {
  std::vector<array::Place> pixels;       ///< of the array, that are built
  std::vector<bool> answers;              ///< to each question that is asked, in order: is any pixel enabled?
  std::span<const machines::Skip> skips;  ///< the questions after which instructions are left out
  const machines::Timeline* timeline = nullptr;
  std::span<const std::uint32_t> picture;  ///< colour of every pixel of the array when the frame is drawn, in row order
};

}  // namespace csgsim::systemc
