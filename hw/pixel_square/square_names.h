#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include "hw/isa/program.h"

namespace csgsim::pixel_square {

/// Which segment of the Program a square is, for those who watch: no hardware reads it.
class SquareNames {
 public:
  void begin(std::span<const isa::Segment> segments) {
    segments_.clear();
    for (std::uint32_t i = 0; i < segments.size(); ++i) segments_.emplace(place_of(segments[i].region), i);
  }

  /// Throws std::out_of_range for a region that is no segment's.
  [[nodiscard]] std::uint32_t segment_of(const isa::Region& region) const { return segments_.at(place_of(region)); }

 private:
  static std::uint64_t place_of(const isa::Region& region) { return std::uint64_t{region.y} << 32U | region.x; }

  std::unordered_map<std::uint64_t, std::uint32_t> segments_;
};

}  // namespace csgsim::pixel_square
