#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>

#include "hw/base/messages.h"

namespace csgsim::app {

/// Tells on standard error, where that is a terminal, how many points of a sweep are done, the rate and the time left.
class SweepProgress {
 public:
  /// `known` of the points were measured before.
  SweepProgress(std::size_t points, std::size_t known, bool wanted)
      : points_(points), known_(known), show_(wanted && ::isatty(STDERR_FILENO) != 0) {
    show();
  }
  ~SweepProgress() {
    if (show_) tell("\r\x1b[K");
  }
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;

  void done() {
    ++measured_;
    show();
  }

 private:
  void show() const {
    if (!show_) return;
    tell(fmt::format("\r\x1b[K{} of {} points", known_ + measured_, points_));
    if (measured_ > 0) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
      const double each = elapsed.count() / static_cast<double>(measured_);
      tell(fmt::format("  {:.3g} points/s  {:.0f} s left", 1.0 / each,
                       each * static_cast<double>(points_ - known_ - measured_)));
    }
  }

  std::size_t points_;
  std::size_t known_;
  std::size_t measured_ = 0;
  bool show_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace csgsim::app
