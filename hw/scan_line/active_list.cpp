#include "hw/scan_line/active_list.h"

#include <algorithm>

namespace csgsim::scan_line {

void ActiveList::begin(std::span<const isa::RowExtent> primitives) {
  primitives_.assign(primitives.begin(), primitives.end());
  active_.clear();
  next_bucket_ = 0;
  buckets_.clear();
  for (std::uint32_t i = 0; i < primitives_.size(); ++i) {
    const std::uint32_t row = primitives_[i].first;
    if (row >= buckets_.size()) buckets_.resize(row + 1);
    buckets_[row].push_back(i);
  }
}

std::size_t ActiveList::advance_to(std::uint32_t row) {
  if (row < next_bucket_) {
    active_.clear();
    next_bucket_ = 0;
  }
  for (; next_bucket_ <= row; ++next_bucket_) {
    if (next_bucket_ >= buckets_.size()) continue;
    const std::vector<std::uint32_t>& bucket = buckets_[next_bucket_];
    active_.insert(active_.end(), bucket.begin(), bucket.end());
  }
  const std::size_t visited = active_.size();
  std::erase_if(active_, [&](std::uint32_t primitive) { return primitives_[primitive].last < row; });
  return visited;
}

}  // namespace csgsim::scan_line
