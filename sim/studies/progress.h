// Progress display of a study.
// Used by the runner.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "hw/base/messages.h"
#include "sim/observe/long_work.h"

namespace csgsim::studies {

/// Shows progress on standard error if it is a terminal: points done, rate and time left. Warns after some seconds if
/// the study will take minutes.
class Progress {
 public:
  /// `known` points were measured before; `threads` points are measured concurrently.
  Progress(std::size_t points, std::size_t known, bool is_shown, unsigned threads = 1)
      : points_(points), known_(known), threads_(threads), is_shown_(is_shown) {
    show();
  }
  ~Progress() {
    if (is_shown_) write_message("\r\x1b[K");
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void finish_point() {
    ++measured_;
    // Points that are measured concurrently are assumed to be nearly done.
    const std::size_t missing = points_ - known_;
    const std::size_t done = std::min(measured_ + threads_ - 1, missing);
    work_.at_point(done, missing);
    show();
  }

 private:
  void show() const {
    if (!is_shown_) return;
    write_message(fmt::format("\r\x1b[K{} of {} points", known_ + measured_, points_));
    if (measured_ > 0) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
      const double each = elapsed.count() / static_cast<double>(measured_);
      write_message(fmt::format("  {:.3g} points/s  {:.0f} s left", 1.0 / each,
                                each * static_cast<double>(points_ - known_ - measured_)));
    }
  }

  std::size_t points_;
  std::size_t known_;
  std::size_t threads_;
  std::size_t measured_ = 0;
  bool is_shown_;
  observe::LongWork work_{"this study", "fewer points and a smaller --size take less time; measured points are kept"};
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace csgsim::studies
