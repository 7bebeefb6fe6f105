#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hw/wave/pieces.h"
#include "hw/wave/tap.h"
#include "hw/wave/writer.h"

namespace csgsim::waves {

/// Writes what the parts of a machine are at over a run as trace events of Chrome ("Trace Event Format", Google, 2016),
/// which Perfetto shows as lanes. A part is a process, each of its taps is a thread, and a stretch of clocks in which
/// it shows the same is a complete event (`"ph": "X"`), of which `args` has the first clock and how many there are.
/// Times are in microseconds from the rising edge of clock 0 on.
class TraceEvents final : public wave::Writer {
 public:
  enum class Shown : std::uint8_t { texts, all };

  /// `write` takes the text, piece by piece.
  TraceEvents(const std::vector<wave::Tap>& taps, Shown shown, std::uint64_t period_ps,
              std::function<void(std::string_view)> write);

  void sample(std::uint64_t clock) override;
  void finish() override;

 private:
  struct Lane {
    std::function<std::string()> text;
    unsigned part = 0;
    unsigned number = 0;
    std::string shown;        ///< empty: nothing
    std::uint64_t begin = 0;  ///< clock from which on it is shown
  };

  void put(std::string_view event);
  void end(Lane& lane, std::uint64_t clock);
  [[nodiscard]] std::string microseconds(std::uint64_t clocks) const;

  std::vector<Lane> lanes_;
  std::uint64_t period_;  ///< picoseconds
  wave::Pieces out_;
  std::uint64_t next_ = 0;  ///< clock that would follow the last one
  bool has_events_ = false;
};

}  // namespace csgsim::waves
