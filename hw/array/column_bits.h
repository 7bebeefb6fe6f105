#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/kernels.h"
#include "hw/array/plane.h"
#include "hw/array/step_log.h"

namespace csgsim::array {

/// What the columns of an array share of streams: the bits of xx*x*x + a*x + c. Of a stream with x*y they share
/// nothing.
class ColumnBits {
 public:
  /// `places`, if there are any: one row of pixels, those of another array side by side, with all of the sum.
  ColumnBits(PlaneShape shape, std::span<const Place> places);

  /// Works them out. The tables are valid until the next call, and as long as the streams are there.
  std::span<const kernels::StreamTable> of(std::span<const Stream> streams);

 private:
  kernels::StreamTable table_of(const Stream& stream, Words& words) const;

  std::uint32_t width_;
  std::size_t row_words_;
  std::size_t stride_;
  std::vector<Place> places_;
  std::vector<Words> words_;  ///< a stream's each
  std::vector<kernels::StreamTable> tables_;
};

}  // namespace csgsim::array
