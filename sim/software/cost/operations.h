// Operation counters.
// Used as template arguments by all methods of software.
#pragma once

#include <cstdint>

#include "hw/processors/operations.h"

namespace csgsim::software {

using processors::Operation;
using processors::operation_kinds;
using processors::operation_rows;
using processors::Operations;

/// Counter that counts operations. Methods are compiled twice, with Counting and with Uncounted.
class Counting {
 public:
  static constexpr bool counts = true;

  void operator()(Operation kind, std::uint64_t times = 1) { done_.counts[static_cast<std::size_t>(kind)] += times; }
  /// Counts a shift of a long by `places` bits.
  void shift(std::uint64_t places) {
    (*this)(Operation::shift_long);
    (*this)(Operation::shifted_bit, places);
  }

  [[nodiscard]] const Operations& done() const { return done_; }

 private:
  Operations done_;
};

/// Counter that does nothing, for full speed.
class Uncounted {
 public:
  static constexpr bool counts = false;

  void operator()(Operation /*kind*/, std::uint64_t /*times*/ = 1) const {}
  void shift(std::uint64_t /*places*/) const {}
  [[nodiscard]] Operations done() const { return {}; }
};

}  // namespace csgsim::software
