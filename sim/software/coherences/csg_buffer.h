// CSG buffer coherence.
// One of the rows of coherences().
#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/software/coherences/list_structure.h"

namespace csgsim::software {

/// The list structure with a pointer into it for each pixel, so that surfaces can be processed in any order from front
/// to back and pixels concurrently (thesis 4.5.4, algorithm 4.1). Here the first surfaces of all rays of a band are
/// processed first, then the second ones, and so on.
template <class Count>
class CsgBuffer : public ListElements<Count> {
 public:
  static constexpr bool goes_by_layers = true;

  using ListElements<Count>::ListElements;

  /// Sets the number of pixels; the buffer has a pointer for each.
  void set_pixels(std::uint64_t pixels) { pixels_ = pixels; }
  [[nodiscard]] std::uint64_t words() const { return ListElements<Count>::words() + pixels_; }

 private:
  std::uint64_t pixels_ = 0;
};

}  // namespace csgsim::software
