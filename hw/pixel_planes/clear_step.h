// Distributes the clearing of pixel memory over clocks. Used by the controllers of hw/pixel_planes and hw/pixel_square.
#pragma once

#include <algorithm>
#include <cstdint>

#include "hw/isa/program.h"
#include "hw/pixel_planes/control_word.h"

namespace csgsim::pixel_planes {

/// The memory bits cleared in clock `clock_index` (from 0) of the `clock_count` clocks that clear a region. The bits
/// are spread evenly over the clocks; bits from `end_address` on are not cleared.
inline ClearStep clear_step(const isa::Region& region, std::uint32_t memory_bits, std::uint32_t clock_index,
                            std::uint32_t clock_count, std::uint32_t end_address) {
  const auto up_to = [&](std::uint64_t elapsed) {
    return static_cast<std::uint16_t>(std::min<std::uint64_t>(elapsed * memory_bits / clock_count, end_address));
  };
  return {.address = up_to(clock_index),
          .bits = static_cast<std::uint16_t>(up_to(std::uint64_t{clock_index} + 1) - up_to(clock_index)),
          .width = static_cast<std::uint16_t>(region.width),
          .height = static_cast<std::uint16_t>(region.height)};
}

}  // namespace csgsim::pixel_planes
