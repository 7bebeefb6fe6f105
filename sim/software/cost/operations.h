#pragma once

#include <cstdint>

#include "hw/processors/operations.h"

namespace csgsim::software {

using processors::Operation;
using processors::operation_kinds;
using processors::operation_rows;
using processors::Operations;

/// Methods are compiled twice: with this they count what they do, where they do it,
class Counting {
 public:
  static constexpr bool counts = true;

  void operator()(Operation kind, std::uint64_t times = 1) { done_.counts[static_cast<std::size_t>(kind)] += times; }
  /// A shift of a long by that many places.
  void shift(std::uint64_t places) {
    (*this)(Operation::shift_long);
    (*this)(Operation::shifted_bit, places);
  }

  [[nodiscard]] const Operations& done() const { return done_; }

 private:
  Operations done_;
};

/// and with this they only do it.
class Uncounted {
 public:
  static constexpr bool counts = false;

  void operator()(Operation /*kind*/, std::uint64_t /*times*/ = 1) const {}
  void shift(std::uint64_t /*places*/) const {}
  [[nodiscard]] Operations done() const { return {}; }
};

}  // namespace csgsim::software
