#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::scan_line {

/// Buckets of primitives by their first row, and the list of primitives active on the current line (thesis 7.2.2).
class ActiveList {
 public:
  /// Sorts the primitives into their buckets; none is active yet.
  void begin(std::span<const isa::RowExtent> primitives);

  [[nodiscard]] std::size_t primitives() const { return primitives_.size(); }

  /// Advances to `row`: adds the buckets up to it, and removes primitives that ended before it. A row above the
  /// previous one begins a new frame, or a new field of an interlaced picture, with an empty list. Returns the number
  /// of primitives visited.
  std::size_t advance_to(std::uint32_t row);

 private:
  std::vector<isa::RowExtent> primitives_;
  std::vector<std::vector<std::uint32_t>> buckets_;  ///< numbers of primitives, by row
  std::vector<std::uint32_t> active_;
  std::uint32_t next_bucket_ = 0;
};

}  // namespace csgsim::scan_line
