// Tables of the column-dependent bits of linear expressions.
// Used by DeferredPixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/kernels.h"
#include "hw/array/plane.h"
#include "hw/array/step_log.h"

namespace csgsim::array {

/// The part of each stream that depends only on the column: the bits of xx*x*x + a*x + c, which are the same in all
/// rows. A stream with x*y has no such part.
class ColumnBits {
 public:
  /// `places`: if not empty, the array is one row of these pixels of another array, and the tables hold the whole sum.
  ColumnBits(PlaneShape shape, std::span<const Place> places);

  /// Computes one table per stream. They are valid until the next call and while the streams exist.
  std::span<const kernels::StreamTable> compute_tables(std::span<const Stream> streams);

 private:
  kernels::StreamTable build_table(const Stream& stream, Words& words) const;

  std::uint32_t width_;
  std::size_t row_words_;
  std::size_t stride_;
  std::vector<Place> places_;
  std::vector<Words> words_;  ///< table memory, one per stream
  std::vector<kernels::StreamTable> tables_;
};

}  // namespace csgsim::array
