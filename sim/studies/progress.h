#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "hw/base/messages.h"
#include "sim/observe/long_work.h"

namespace csgsim::studies {

/// Tells on standard error, where that is a terminal, how many points of a study are done, the rate and the time left;
/// and warns, after some seconds, of a study that will take minutes.
class Progress {
 public:
  /// `known` of the points were measured before; so many are measured at the same time.
  Progress(std::size_t points, std::size_t known, bool wanted, unsigned threads = 1)
      : points_(points), known_(known), threads_(threads), show_(wanted) {
    show();
  }
  ~Progress() {
    if (show_) tell("\r\x1b[K");
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void done() {
    ++measured_;
    // Those that are measured at the same time are nearly done too.
    const std::size_t missing = points_ - known_;
    const std::size_t done = std::min(measured_ + threads_ - 1, missing);
    work_.at_point(done, missing);
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
  std::size_t threads_;
  std::size_t measured_ = 0;
  bool show_;
  observe::LongWork work_{"this study", "fewer points and a smaller --size take less; what is measured is kept"};
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace csgsim::studies
