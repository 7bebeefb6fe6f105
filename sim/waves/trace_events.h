// Writes waveforms as Chrome trace events.
// Used by record.cpp.
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

/// Writes the activities of a machine's units over a run as Chrome trace events ("Trace Event Format", Google, 2016),
/// which Perfetto shows as lanes. A unit is a process, each of its taps is a thread, and a stretch of clocks with the
/// same value is a complete event (`"ph": "X"`), whose `args` hold the first clock and the number of clocks. Times are
/// in microseconds from the rising edge of clock 0.
class TraceEvents final : public wave::Writer {
 public:
  enum class Shown : std::uint8_t { texts, all };

  /// `write` receives the text in pieces.
  TraceEvents(const std::vector<wave::Tap>& taps, Shown shown, std::uint64_t period_ps,
              std::function<void(std::string_view)> write);

  void sample(std::uint64_t clock) override;
  void finish() override;

 private:
  struct Lane {
    std::function<std::string()> text;
    unsigned part = 0;
    unsigned number = 0;
    std::string shown;        ///< current text; empty: none
    std::uint64_t begin = 0;  ///< first clock of that text
  };

  void put(std::string_view event);
  void end(Lane& lane, std::uint64_t clock);
  [[nodiscard]] std::string microseconds(std::uint64_t clocks) const;

  std::vector<Lane> lanes_;
  std::uint64_t period_;  ///< picoseconds
  wave::Pieces out_;
  std::uint64_t next_ = 0;  ///< clock after the last sampled one
  bool has_events_ = false;
};

}  // namespace csgsim::waves
