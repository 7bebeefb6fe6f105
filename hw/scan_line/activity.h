#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hw/machines/clock_tally.h"

namespace csgsim::scan_line {

/// Where a part of a scan-line array spends its clocks. Every clock of the frame is in one of these.
#define CSGSIM_LINE_ACTIVITIES(A)                                                                        \
  A(sorting, "the host puts primitives into the buckets of their first lines")                           \
  A(updating, "the host goes through the active list for a line")                                        \
  A(preparing, "the host prepares the instructions of a line")                                           \
  A(starting, "the host hands a line over to a link")                                                    \
  A(latency, "the frame's first word is on its way over the link")                                       \
  A(sending, "a word is sent")                                                                           \
  A(entering, "a packet enters the chain")                                                               \
  A(showing, "a pixel is at the refresh port")                                                           \
  A(waiting_for_host, "no line has been handed over")                                                    \
  A(waiting_for_link, "the link has not begun with the chain's line before; no packet has come over it") \
  A(waiting_for_entry, "the FIFO of the link is full")                                                   \
  A(waiting_for_refresh, "a mark waits until the refresh path is free")                                  \
  A(waiting_for_line, "no line is in the shift chain")                                                   \
  A(done, "nothing is left to do")

enum class LineActivity : std::uint8_t {
#define CSGSIM_LINE_ACTIVITY_ENUMERATOR(name, meaning) name,
  CSGSIM_LINE_ACTIVITIES(CSGSIM_LINE_ACTIVITY_ENUMERATOR)
#undef CSGSIM_LINE_ACTIVITY_ENUMERATOR
};

struct LineActivityInfo {
  std::string_view name;
  std::string_view meaning;
};

inline constexpr auto line_activities = std::to_array<LineActivityInfo>({
#define CSGSIM_LINE_ACTIVITY_ROW(name, meaning) LineActivityInfo{#name, meaning},
    CSGSIM_LINE_ACTIVITIES(CSGSIM_LINE_ACTIVITY_ROW)
#undef CSGSIM_LINE_ACTIVITY_ROW
});

/// Clocks of one part by activity.
using LineClocks = machines::ClockTally<LineActivity, line_activities.size()>;

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

  /// What it does until the next edge, by name; nothing before the first.
  [[nodiscard]] std::string_view now() const {
    return begun_ ? line_activities[static_cast<std::size_t>(now_)].name : std::string_view();
  }

 private:
  bool begun_ = false;
  LineActivity now_{};
  LineClocks clocks_;
};

}  // namespace csgsim::scan_line
