#pragma once

#include <cstdint>

#include "hw/multi_processor/pixel_memory.h"

namespace csgsim::multi_processor {

/// The pixels that a node has of a subsegment, after an instruction or at the end.
struct NodeState {
  std::uint64_t clocks = 0;          ///< of the instruction at each of them; 0 without pixels
  std::uint64_t enabled_pixels = 0;  ///< when it began
  PixelMemory pixels;                ///< empty where nobody looks
};

}  // namespace csgsim::multi_processor
