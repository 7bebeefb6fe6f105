#include "hw/scan_line/active_list.h"

#include <algorithm>
#include <map>
#include <utility>

namespace csgsim::scan_line {

std::vector<Extent> extents_of(std::span<const isa::Segment> lines) {
  std::map<std::uint32_t, Extent> found;
  for (const isa::Segment& line : lines) {
    const std::uint32_t row = line.region.y;
    for (const isa::Instruction& instruction : line.instructions) {
      for (const std::uint32_t primitive : {instruction.origin.primitive, instruction.origin.node}) {
        if (primitive == isa::no_primitive) continue;
        Extent& extent = found.try_emplace(primitive, Extent{row, row}).first->second;
        extent = {std::min(extent.first, row), std::max(extent.last, row)};
      }
    }
  }
  std::vector<Extent> extents;
  extents.reserve(found.size());
  for (const auto& [primitive, extent] : found) extents.push_back(extent);
  return extents;
}

void ActiveList::begin(std::vector<Extent> primitives) {
  primitives_ = std::move(primitives);
  active_.clear();
  next_bucket_ = 0;
  buckets_.clear();
  for (std::uint32_t i = 0; i < primitives_.size(); ++i) {
    const std::uint32_t row = primitives_[i].first;
    if (row >= buckets_.size()) buckets_.resize(row + 1);
    buckets_[row].push_back(i);
  }
}

std::size_t ActiveList::go_to(std::uint32_t row) {
  if (row < next_bucket_) {
    active_.clear();
    next_bucket_ = 0;
  }
  for (; next_bucket_ <= row; ++next_bucket_) {
    if (next_bucket_ >= buckets_.size()) continue;
    const std::vector<std::uint32_t>& bucket = buckets_[next_bucket_];
    active_.insert(active_.end(), bucket.begin(), bucket.end());
  }
  const std::size_t looked_at = active_.size();
  std::erase_if(active_, [&](std::uint32_t primitive) { return primitives_[primitive].last < row; });
  return looked_at;
}

}  // namespace csgsim::scan_line
