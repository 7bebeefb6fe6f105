#include "hw/isa/extents.h"

#include <algorithm>
#include <cstdint>
#include <map>

namespace csgsim::isa {

std::vector<RowExtent> compute_row_extents(std::span<const Segment> segments) {
  std::map<std::uint32_t, RowExtent> found;
  for (const Segment& line : segments) {
    const auto row = static_cast<std::uint16_t>(line.region.y);
    for (const Instruction& instruction : line.instructions) {
      for (const std::uint32_t piece : {instruction.origin.primitive, instruction.origin.node}) {
        if (piece == no_primitive) continue;
        RowExtent& extent = found.try_emplace(piece, RowExtent{row, row}).first->second;
        extent = {std::min(extent.first, row), std::max(extent.last, row)};
      }
    }
  }
  std::vector<RowExtent> extents;
  extents.reserve(found.size());
  for (const auto& [piece, extent] : found) extents.push_back(extent);
  return extents;
}

}  // namespace csgsim::isa
