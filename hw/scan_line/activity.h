#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hw/machines/clock_tally.h"

namespace csgsim::scan_line {

/// Where a part of a scan-line array spends its clocks. Every clock of the frame is in one of these.
enum class LineActivity : std::uint8_t {
  sorting,              ///< the host puts primitives into the buckets of their first lines
  updating,             ///< the host goes through the active list for a line
  preparing,            ///< the host prepares the instructions of a line
  starting,             ///< the host hands a line over to a link
  latency,              ///< the frame's first word is on its way over the link
  sending,              ///< a word is sent
  entering,             ///< a packet enters the chain
  showing,              ///< a pixel is at the refresh port
  waiting_for_host,     ///< no line has been handed over
  waiting_for_link,     ///< the link has not begun with the chain's line before; no packet has come over it
  waiting_for_entry,    ///< the FIFO of the link is full
  waiting_for_refresh,  ///< a mark waits until the refresh path is free
  waiting_for_line,     ///< no line is in the shift chain
  done,                 ///< nothing is left to do
};

inline constexpr auto line_activity_names = std::to_array<std::string_view>(
    {"sorting", "updating", "preparing", "starting", "latency", "sending", "entering", "showing", "waiting_for_host",
     "waiting_for_link", "waiting_for_entry", "waiting_for_refresh", "waiting_for_line", "done"});

/// Clocks of one part by activity.
using LineClocks = machines::ClockTally<LineActivity, line_activity_names.size()>;

/// Counts the clocks of a part. At each edge the part says what it does until the next.
class ActivityCounter {
 public:
  void begin() { *this = {}; }
  void edge(LineActivity next) {
    if (begun_) clocks_.add(now_);
    now_ = next;
    begun_ = true;
  }
  [[nodiscard]] const LineClocks& clocks() const { return clocks_; }

  /// Of a frame of so many clocks, after whose last edge that was counted the part had nothing left to do.
  [[nodiscard]] LineClocks clocks_of(std::uint64_t frame) const {
    LineClocks all = clocks_;
    const std::uint64_t counted = clocks_.total();
    if (counted >= frame) return all;
    all.add(now_);
    all.add(LineActivity::done, frame - counted - 1);
    return all;
  }

  /// What it does until the next edge, by name; nothing before the first.
  [[nodiscard]] std::string_view now() const {
    return begun_ ? line_activity_names.at(static_cast<std::size_t>(now_)) : std::string_view();
  }

 private:
  bool begun_ = false;
  LineActivity now_{};
  LineClocks clocks_;
};

}  // namespace csgsim::scan_line
