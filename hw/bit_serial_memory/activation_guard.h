#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <systemc>

#include "hw/bit_serial_memory/figures.h"
#include "hw/systemc/kernel.h"

namespace csgsim::bit_serial_memory {

/// Enforces the minimum distances of activations that the chips' power supply requires: at least tRRD between two, and
/// at most four within tFAW.
class ActivationGuard final : public sc_core::sc_module {
 public:
  ActivationGuard(sc_core::sc_module_name name, const RankClocks& rank, const sc_core::sc_time& period)
      : sc_core::sc_module(name), gap_(rank.activation_gap * period), window_(rank.window * period) {}

  /// First edge at which the next activation is allowed.
  [[nodiscard]] sc_core::sc_time allowed() const { return std::max(apart_, four_[oldest_]); }
  /// Records an activation at the current edge.
  void activate() {
    const sc_core::sc_time now = systemc::now();
    apart_ = now + gap_;
    four_[oldest_] = now + window_;
    oldest_ = (oldest_ + 1) % four_.size();
  }
  /// First edge at which no earlier activation delays the next four: the gap has passed and the window is empty.
  [[nodiscard]] sc_core::sc_time idle() const { return std::max(apart_, *std::ranges::max_element(four_)); }
  void delay(const sc_core::sc_time& duration) {
    apart_ += duration;
    for (sc_core::sc_time& one : four_) one += duration;
  }

 private:
  const sc_core::sc_time gap_;
  const sc_core::sc_time window_;
  sc_core::sc_time apart_;
  std::array<sc_core::sc_time, 4> four_;  ///< edges at which the last four activations leave the window
  std::size_t oldest_ = 0;
};

}  // namespace csgsim::bit_serial_memory
