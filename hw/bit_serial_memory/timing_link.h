#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace csgsim::bit_serial_memory {

/// Analytic timing of commands on the link. The host sends commands without gaps while the controller's queue has room.
class LinkTiming {
 public:
  /// `places`: capacity of the queue. `latency`: clocks from a request to the first word; the first request is at clock
  /// 0.
  LinkTiming(std::uint32_t places, std::uint32_t latency)
      : places_(places), latency_(latency), host_free_(latency), start_clocks_(places) {}

  /// Clock at which the last word of the next command arrives. The command occupies the link for `clocks` clocks.
  std::uint64_t arrival(std::uint64_t clocks) {
    const std::uint64_t from = start();
    host_free_ = from + clocks;
    ++sent_;
    sending_ += clocks;
    return host_free_;
  }

  /// Records that the oldest command in the queue begins at `clock`.
  void begin(std::uint64_t clock) { start_clocks_[taken_++ % places_] = clock; }

  /// Whether the queue has room for another command; next_start() is the clock at which its transmission begins.
  [[nodiscard]] bool has_room() const { return sent_ - taken_ < places_; }
  [[nodiscard]] std::uint64_t next_start() const { return start(); }

  /// Records that the host resumes at another instruction: the command on the link and those in the queue are dropped.
  void jump(std::uint64_t clock) {
    if (host_free_ > clock) sending_ -= host_free_ - clock;
    host_free_ = clock + latency_;
    sent_ = 0;
    taken_ = 0;
  }

  [[nodiscard]] std::uint64_t sending() const { return sending_; }

 private:
  [[nodiscard]] std::uint64_t start() const {
    return sent_ < places_ ? host_free_ : std::max(host_free_, start_clocks_[sent_ % places_]);
  }

  std::uint32_t places_;
  std::uint32_t latency_;
  std::uint64_t host_free_;
  std::uint64_t sent_ = 0;                   ///< commands sent since the last request
  std::uint64_t taken_ = 0;                  ///< number of these commands taken from the queue
  std::vector<std::uint64_t> start_clocks_;  ///< start clocks of the last commands, a ring
  std::uint64_t sending_ = 0;
};

}  // namespace csgsim::bit_serial_memory
