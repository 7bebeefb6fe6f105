#pragma once

#include <algorithm>
#include <cstdint>

#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/regions.h"

namespace csgsim::multi_processor {

/// The turns in which a screen has the memory of a node, one after the other.
class ScreenTurns {
 public:
  ScreenTurns(const RefreshFigures& figures, std::uint64_t clock_hz) : figures_(figures), clock_hz_(clock_hz) {}

  /// A frame begins in that clock, and shows so many pixels of the node, of so many bits.
  void begin(std::uint64_t clock, std::uint64_t pixels, std::uint32_t colour_bits) {
    rate_ = figures_.rate * ((pixels * colour_bits + figures_.bits - 1) / figures_.bits);
    whole_ = clock;
    rest_ = 0;
    if (rate_ > 0) next();
  }

  /// Of the clocks from that one on, how many there are until the next turn: 0 in one. Clocks never go back.
  [[nodiscard]] std::uint64_t free_from(std::uint64_t clock, std::uint64_t most) {
    if (rate_ == 0) return most;
    while (first() + figures_.clocks <= clock) next();
    return first() <= clock ? 0 : std::min(most, first() - clock);
  }

  /// Is that clock, none before the last that was asked for, in a turn? At most the next is known.
  [[nodiscard]] bool has(std::uint64_t clock) const {
    return rate_ > 0 && first() <= clock && clock < first() + figures_.clocks;
  }

  /// Of such a turn, how many are left.
  [[nodiscard]] std::uint64_t left_from(std::uint64_t clock) const { return first() + figures_.clocks - clock; }

 private:
  [[nodiscard]] std::uint64_t first() const { return whole_ + (rest_ > 0 ? 1 : 0); }

  void next() {
    whole_ += clock_hz_ / rate_;
    rest_ += clock_hz_ % rate_;
    if (rest_ < rate_) return;
    rest_ -= rate_;
    ++whole_;
  }

  RefreshFigures figures_;
  std::uint64_t clock_hz_;
  std::uint64_t rate_ = 0;   ///< turns a second
  std::uint64_t whole_ = 0;  ///< clocks before the turn at hand, or to come, rounded down
  std::uint64_t rest_ = 0;   ///< of a clock, in parts of which there are `rate_`
};

}  // namespace csgsim::multi_processor
