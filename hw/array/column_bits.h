#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/kernels.h"
#include "hw/array/plane.h"
#include "hw/array/step_log.h"

namespace csgsim::array {

/// What the columns of an array share of streams: the bits of a*x + c.
class ColumnBits {
 public:
  /// `places`, if there are any: one row of pixels, those of another array side by side, with b*y in the sum too.
  ColumnBits(PlaneShape shape, std::span<const Place> places);

  /// Works them out. The tables are valid until the next call.
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
