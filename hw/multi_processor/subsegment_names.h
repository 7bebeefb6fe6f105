#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "hw/isa/program.h"

namespace csgsim::multi_processor {

/// Which segment of the Program a subsegment is, for those who watch: no hardware reads it.
class SubsegmentNames {
 public:
  void begin(std::span<const isa::Segment> parts) {
    numbers_.clear();
    for (std::uint32_t i = 0; i < parts.size(); ++i) numbers_[{parts[i].region.x, parts[i].region.y}] = i;
  }

  /// Throws std::out_of_range for a region that is none's.
  [[nodiscard]] std::uint32_t number_of(const isa::Region& region) const { return numbers_.at({region.x, region.y}); }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;  ///< by the region's top left
};

}  // namespace csgsim::multi_processor
