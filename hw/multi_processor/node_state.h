#pragma once

#include <cstdint>

#include "hw/multi_processor/pixel_memory.h"

namespace csgsim::multi_processor {

/// The pixels that a node has of a subsegment, after an instruction or at the end.
struct NodeState {
  std::uint64_t clocks = 0;          ///< of all of the instruction at one of them; 0 without pixels
  std::uint64_t enabled_pixels = 0;  ///< when it began
  std::uint64_t pixel_clocks = 0;    ///< of the instruction at all of them
  std::uint64_t enabled_clocks = 0;  ///< of these, at those that were enabled
  PixelMemory pixels;                ///< empty where nobody looks
};

}  // namespace csgsim::multi_processor
