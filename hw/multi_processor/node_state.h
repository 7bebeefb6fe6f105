#pragma once

#include <cstdint>

#include "hw/multi_processor/pixel_memory.h"

namespace csgsim::multi_processor {

/// A node's pixels of a subsegment after an instruction, or at the end.
struct NodeState {
  std::uint64_t clocks = 0;          ///< clocks of the whole instruction at one pixel; 0 without pixels
  std::uint64_t enabled_pixels = 0;  ///< number of pixels enabled when the instruction began
  std::uint64_t pixel_clocks = 0;    ///< clocks of the instruction at all pixels
  std::uint64_t enabled_clocks = 0;  ///< the part of these at enabled pixels
  PixelMemory pixels;                ///< empty if no listener reads them
};

}  // namespace csgsim::multi_processor
