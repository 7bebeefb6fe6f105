#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace csgsim::bit_serial_memory {

/// When commands come over the link, worked out. The host sends the words of one after those of another, as long as
/// there is room in the controller's queue for the command.
class LinkTiming {
 public:
  /// `places`: of the queue. `latency`: from a request, the first at clock 0, to the first word.
  LinkTiming(std::uint32_t places, std::uint32_t latency)
      : places_(places), latency_(latency), host_free_(latency), begun_(places) {}

  /// The clock at which the last word of the next command has come, if it takes so long on the link.
  std::uint64_t arrival(std::uint64_t clocks) {
    const std::uint64_t from = start();
    host_free_ = from + clocks;
    ++sent_;
    sending_ += clocks;
    return host_free_;
  }

  /// The oldest command in the queue begins.
  void begin(std::uint64_t clock) { begun_[taken_++ % places_] = clock; }

  /// Is there room for another, and when is it begun to be sent?
  [[nodiscard]] bool has_room() const { return sent_ - taken_ < places_; }
  [[nodiscard]] std::uint64_t next_start() const { return start(); }

  /// The host is asked to go on from elsewhere: the command on the link and those in the queue are lost.
  void jump(std::uint64_t clock) {
    if (host_free_ > clock) sending_ -= host_free_ - clock;
    host_free_ = clock + latency_;
    sent_ = 0;
    taken_ = 0;
  }

  [[nodiscard]] std::uint64_t sending() const { return sending_; }

 private:
  [[nodiscard]] std::uint64_t start() const {
    return sent_ < places_ ? host_free_ : std::max(host_free_, begun_[sent_ % places_]);
  }

  std::uint32_t places_;
  std::uint32_t latency_;
  std::uint64_t host_free_;
  std::uint64_t sent_ = 0;            ///< since the last request
  std::uint64_t taken_ = 0;           ///< of these
  std::vector<std::uint64_t> begun_;  ///< clocks at which the last ones began, a ring
  std::uint64_t sending_ = 0;
};

}  // namespace csgsim::bit_serial_memory
