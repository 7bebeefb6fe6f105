#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <systemc>
#include <vector>

#include "hw/scan_line/activity.h"
#include "hw/scan_line/packet_signals.h"
#include "hw/scan_line/periods.h"
#include "hw/scan_line/picture_lines.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::scan_line {

/// A frame as it came out of the refresh ports.
struct ShownFrame {
  std::uint64_t clocks = 0;        ///< from the first in which the host works until the last pixel was at its port
  std::uint64_t drain_clocks = 0;  ///< of these, after the last mark has entered
  std::size_t last_chain = 0;      ///< the first of those whose last pixel came last
  std::vector<LineClocks> chains;  ///< of the refresh port of each
  std::vector<std::vector<std::uint32_t>> lines;  ///< of each the pixels from left to right; in the frame's order
};

/// The screen's end of all chains: puts together what comes out of their refresh ports, and counts the frames' clocks.
/// A frame may begin while pixels of those before are still to come.
class RefreshCollector final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_in<RefreshPixel>> refresh;  ///< one a chain
  sc_core::sc_vector<sc_core::sc_in<bool>> entering;         ///< a line of that chain has not entered whole
  sc_core::sc_out<std::uint64_t> frames{"frames"};           ///< that have come whole

  RefreshCollector(sc_core::sc_module_name name, std::uint32_t chains);

  /// A frame begins, as wide as those of which pixels are to come. All marks of the one before have entered.
  void begin(const PictureLines& frame);

  /// The oldest frame that has come whole and has not been taken.
  ShownFrame take();

  /// For waves: of the chain, whose pixels are at the port or come next.
  [[nodiscard]] std::size_t line_of(std::size_t chain) const;

 private:
  struct Coming {
    ShownFrame shown;
    std::size_t pixels = 0;  ///< of a line
    Periods periods{};
    std::vector<std::size_t> line_of_chain;  ///< whose pixels come
    std::size_t missing_lines = 0;
    std::uint64_t last_pixel = 0;  ///< clock in which it came
    bool enters = true;            ///< marks of it, for all that was seen at the last edge
  };

  void on_clock() override;
  void count(Coming& frame, bool is_last);
  void look_at(std::size_t chain);
  void collect(Coming& frame, std::size_t chain, std::uint32_t colour);
  [[nodiscard]] bool any_enters() const;

  std::deque<Coming> coming_;     ///< frames that have begun, the oldest first
  std::deque<ShownFrame> whole_;  ///< that have not been taken
  std::uint64_t frames_done_ = 0;
};

}  // namespace csgsim::scan_line
