#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hw/machines/clock_tally.h"

namespace csgsim::scan_line {

/// Activities of the units of a scan-line array. Each clock of the frame counts for exactly one.
enum class LineActivity : std::uint8_t {
  sorting,              ///< the host sorts primitives into the buckets of their first lines
  updating,             ///< the host updates the active list for a line
  preparing,            ///< the host prepares the instructions of a line
  starting,             ///< the host transfers a line to a link
  latency,              ///< the frame's first word is in transit on the link
  sending,              ///< a word is sent
  entering,             ///< a packet enters the chain
  showing,              ///< a pixel is at the refresh port
  waiting_for_host,     ///< no line has been transferred by the host
  waiting_for_link,     ///< the link has not begun the previous line of the chain, or no packet has arrived over it
  waiting_for_entry,    ///< the FIFO of the link is full
  waiting_for_refresh,  ///< a mark waits for the refresh path to become free
  waiting_for_line,     ///< no line is in the shift chain
  done,                 ///< no work is left
};

inline constexpr auto line_activity_names = std::to_array<std::string_view>(
    {"sorting", "updating", "preparing", "starting", "latency", "sending", "entering", "showing", "waiting_for_host",
     "waiting_for_link", "waiting_for_entry", "waiting_for_refresh", "waiting_for_line", "done"});

/// Clocks of one unit by activity.
using LineClocks = machines::ClockTally<LineActivity, line_activity_names.size()>;

/// Counts the clocks of a unit. At each edge the unit reports its activity until the next edge.
class ActivityCounter {
 public:
  void begin() { *this = {}; }
  /// Counts the clock since the last edge, and sets the activity until the next edge.
  void edge(LineActivity activity) {
    if (begun_) clocks_.add(now_);
    now_ = activity;
    begun_ = true;
  }
  [[nodiscard]] const LineClocks& clocks() const { return clocks_; }

  /// Clocks by activity in a frame of `frame_clocks` clocks; clocks after the last counted edge count as `done`.
  [[nodiscard]] LineClocks clocks_of(std::uint64_t frame_clocks) const {
    LineClocks all = clocks_;
    const std::uint64_t counted = clocks_.total();
    if (counted >= frame_clocks) return all;
    all.add(now_);
    all.add(LineActivity::done, frame_clocks - counted - 1);
    return all;
  }

  /// Name of the activity until the next edge; empty before the first edge.
  [[nodiscard]] std::string_view now() const {
    return begun_ ? line_activity_names.at(static_cast<std::size_t>(now_)) : std::string_view();
  }

 private:
  bool begun_ = false;
  LineActivity now_{};
  LineClocks clocks_;
};

}  // namespace csgsim::scan_line
