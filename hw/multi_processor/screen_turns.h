#pragma once

#include <algorithm>
#include <cstdint>

#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/regions.h"

namespace csgsim::multi_processor {

/// Computes, one after the other, the turns in which the screen reads a node's memory and the node stalls.
class ScreenTurns {
 public:
  ScreenTurns(const RefreshFigures& figures, std::uint64_t clock_hz) : figures_(figures), clock_hz_(clock_hz) {}

  /// Begins a frame in that clock; the screen shows `pixels` pixels of the node, of `colour_bits` bits each.
  void begin(std::uint64_t clock, std::uint64_t pixels, std::uint32_t colour_bits) {
    rate_ = figures_.rate * ((pixels * colour_bits + figures_.bits - 1) / figures_.bits);
    whole_clocks_ = clock;
    fraction_ = 0;
    if (rate_ > 0) next();
  }

  /// Number of free clocks, at most `limit`, from `clock` to the next turn; 0 during a turn. `clock` must not decrease.
  [[nodiscard]] std::uint64_t free_clocks_from(std::uint64_t clock, std::uint64_t limit) {
    if (rate_ == 0) return limit;
    while (first() + figures_.clocks <= clock) next();
    return first() <= clock ? 0 : std::min(limit, first() - clock);
  }

  /// Whether `clock` is in a turn; it must be neither before the last requested clock nor after the next turn.
  [[nodiscard]] bool is_in_turn(std::uint64_t clock) const {
    return rate_ > 0 && first() <= clock && clock < first() + figures_.clocks;
  }

  /// Clocks left of the turn that contains `clock`.
  [[nodiscard]] std::uint64_t turn_clocks_left(std::uint64_t clock) const { return first() + figures_.clocks - clock; }

 private:
  [[nodiscard]] std::uint64_t first() const { return whole_clocks_ + (fraction_ > 0 ? 1 : 0); }

  void next() {
    whole_clocks_ += clock_hz_ / rate_;
    fraction_ += clock_hz_ % rate_;
    if (fraction_ < rate_) return;
    fraction_ -= rate_;
    ++whole_clocks_;
  }

  RefreshFigures figures_;
  std::uint64_t clock_hz_;
  std::uint64_t rate_ = 0;          ///< turns per second
  std::uint64_t whole_clocks_ = 0;  ///< clocks before the current or next turn, rounded down
  std::uint64_t fraction_ = 0;      ///< fraction of a clock, in units of 1 / rate_
};

}  // namespace csgsim::multi_processor
