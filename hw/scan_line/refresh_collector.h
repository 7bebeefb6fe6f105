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

/// A frame as received from the refresh ports.
struct ShownFrame {
  std::uint64_t clocks = 0;  ///< clocks from the first in which the host works until the last pixel was at its port
  std::uint64_t drain_clocks = 0;  ///< part of `clocks` after the last mark entered
  /// Chain from which the frame's last pixel arrived; if several chains delivered a pixel in that clock, the lowest of
  /// their numbers.
  std::size_t last_chain = 0;
  std::vector<LineClocks> chains;  ///< clocks of each chain's refresh port, by activity
  /// Pixels of each line from left to right; lines in the frame's order.
  std::vector<std::vector<std::uint32_t>> lines;
};

/// The screen's end of all chains: collects the output of their refresh ports, and counts the frames' clocks. A frame
/// may begin before all pixels of earlier frames have arrived.
class RefreshCollector final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_in<RefreshPixel>> refresh;  ///< one per chain
  /// Per chain, whether some of its lines have not entered completely.
  sc_core::sc_vector<sc_core::sc_in<bool>> entering;
  sc_core::sc_out<std::uint64_t> frames{"frames"};  ///< number of complete frames

  RefreshCollector(sc_core::sc_module_name name, std::uint32_t chains);

  /// Begins a frame. Its width must equal that of frames whose pixels have not all arrived. All marks of the previous
  /// frame must have entered.
  void begin(const PictureLines& frame);

  /// Removes and returns the oldest complete frame.
  ShownFrame pop_frame();

  /// For waves: the line of the pixel at the chain's port or, if there is none, of the next pixel.
  [[nodiscard]] std::size_t line_of(std::size_t chain) const;

 private:
  struct PendingFrame {
    ShownFrame shown;
    std::size_t pixels = 0;  ///< pixels of a line
    Periods periods{};
    std::vector<std::size_t> line_of_chain;  ///< for each chain, the line of its next pixel
    std::size_t missing_lines = 0;
    std::uint64_t last_pixel = 0;  ///< clock in which the last pixel arrived
    bool entering_marks = true;    ///< whether marks of the frame had not entered at the last edge
  };

  void on_clock() override;
  void count_clock(PendingFrame& frame, bool is_last);
  void poll(std::size_t chain);
  void collect(PendingFrame& frame, std::size_t chain, std::uint32_t colour);
  [[nodiscard]] bool any_entering() const;

  std::deque<PendingFrame> pending_;  ///< frames that have begun, the oldest first
  std::deque<ShownFrame> complete_;   ///< complete frames that have not been removed with pop_frame()
  std::uint64_t frames_done_ = 0;
};

}  // namespace csgsim::scan_line
