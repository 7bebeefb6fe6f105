// Maps regions to segment numbers.
// Used by hw/pixel_square and hw/multi_processor.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "hw/isa/program.h"

namespace csgsim::systemc {

/// Finds the segment of the Program that has a given region. Only reports need this; it models no hardware.
class SegmentNames {
 public:
  /// Sets the segments of the Program that is drawn next.
  void begin(std::span<const isa::Segment> segments) {
    numbers_.clear();
    for (std::uint32_t i = 0; i < segments.size(); ++i) numbers_[{segments[i].region.x, segments[i].region.y}] = i;
  }

  /// Throws std::out_of_range for a region that belongs to no segment.
  [[nodiscard]] std::uint32_t segment_of(const isa::Region& region) const { return numbers_.at({region.x, region.y}); }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;  ///< by top left corner of the region
};

}  // namespace csgsim::systemc
