#pragma once

#include <rapidcheck.h>

#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::testing {

/// Asserts that the regions partition the picture: each pixel lies in exactly one region and no region extends past the
/// edge.
inline void assert_covered_once(const std::vector<isa::Region>& regions, machines::Size picture) {
  std::vector<int> covered(std::size_t{picture.width} * picture.height);
  for (const isa::Region& region : regions) {
    RC_ASSERT(region.width > 0U && region.height > 0U);
    for (std::uint32_t y = region.y; y < region.y + region.height; ++y) {
      for (std::uint32_t x = region.x; x < region.x + region.width; ++x) {
        RC_ASSERT(x < picture.width && y < picture.height);
        ++covered[std::size_t{y} * picture.width + x];
      }
    }
  }
  RC_ASSERT(covered == std::vector<int>(covered.size(), 1));
}

}  // namespace csgsim::testing
