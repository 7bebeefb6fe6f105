// Counts open pages.
// Used by server.h.
#pragma once

#include <chrono>

namespace csgsim::viewer {

/// Counts open pages, and records when the last one was closed.
class Pages {
 public:
  void open() {
    ++open_;
    has_been_ = true;
  }
  void close() {
    --open_;
    closed_ = Clock::now();
  }

  /// Whether at least one page has been opened, none is open, and the last was closed longer ago than `patience`.
  [[nodiscard]] bool are_closed_for(std::chrono::milliseconds patience) const {
    return has_been_ && open_ == 0 && Clock::now() - closed_ > patience;
  }

 private:
  using Clock = std::chrono::steady_clock;

  int open_ = 0;
  bool has_been_ = false;
  Clock::time_point closed_;
};

}  // namespace csgsim::viewer
