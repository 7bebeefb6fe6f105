#pragma once

#include <cstddef>

#include "hw/machines/accounts.h"

namespace csgsim::pixel_square {

/// Counts the clocks of a part by what it did in each.
class ActivityCounter {
 public:
  void clear() { clocks_ = {}; }
  void count(machines::SquareActivity activity) { ++clocks_[static_cast<std::size_t>(activity)]; }

  [[nodiscard]] const machines::SquareClocks& clocks() const { return clocks_; }

 private:
  machines::SquareClocks clocks_{};
};

}  // namespace csgsim::pixel_square
