#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::scan_line {

/// Buckets of primitives by their first row, and the list of those that are active on the line at hand (thesis 7.2.2).
class ActiveList {
 public:
  /// Puts the primitives into their buckets; none is active yet.
  void begin(std::span<const isa::RowExtent> primitives);

  [[nodiscard]] std::size_t primitives() const { return primitives_.size(); }

  /// Goes on to that row: takes in the buckets up to it, and leaves out the primitives that ended before it. A row not
  /// below the one before begins a field, with an empty list. Returns how many primitives were looked at.
  std::size_t go_to(std::uint32_t row);

 private:
  std::vector<isa::RowExtent> primitives_;
  std::vector<std::vector<std::uint32_t>> buckets_;  ///< numbers of primitives, by row
  std::vector<std::uint32_t> active_;
  std::uint32_t next_bucket_ = 0;
};

}  // namespace csgsim::scan_line
