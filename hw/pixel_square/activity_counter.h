#pragma once

#include <cstddef>

#include "hw/pixel_square/account.h"

namespace csgsim::pixel_square {

/// Counts the clocks of a part by what it did in each.
class ActivityCounter {
 public:
  void clear() { clocks_ = {}; }
  void count(SquareActivity activity) { ++clocks_[static_cast<std::size_t>(activity)]; }

  [[nodiscard]] const SquareClocks& clocks() const { return clocks_; }

 private:
  SquareClocks clocks_{};
};

}  // namespace csgsim::pixel_square
