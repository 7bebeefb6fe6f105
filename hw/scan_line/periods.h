#pragma once

#include <cstdint>

namespace csgsim::scan_line {

/// Counts the clock periods that have ended since the first edge after begin().
class Periods {
 public:
  void begin() { *this = {}; }
  void edge() {
    if (begun_) ++count_;
    begun_ = true;
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  bool begun_ = false;
  std::uint64_t count_ = 0;
};

}  // namespace csgsim::scan_line
