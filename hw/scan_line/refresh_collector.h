#pragma once

#include <cstddef>
#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/scan_line/activity.h"
#include "hw/scan_line/packet_signals.h"
#include "hw/scan_line/periods.h"
#include "hw/scan_line/picture_lines.h"
#include "hw/systemc/clocked_module.h"

namespace csgsim::scan_line {

/// The screen's end of all chains: puts together what comes out of their refresh ports, and counts the frame's clocks.
class RefreshCollector final : public systemc::ClockedModule {
 public:
  sc_core::sc_vector<sc_core::sc_in<RefreshPixel>> refresh;  ///< one a chain
  sc_core::sc_vector<sc_core::sc_in<bool>> entering;         ///< a line of that chain has not entered whole
  sc_core::sc_out<std::uint64_t> frames{"frames"};           ///< that have come whole

  RefreshCollector(sc_core::sc_module_name name, std::uint32_t chains);

  void begin(const PictureLines& frame);

  /// From the first in which the host works until that in which the last pixel was at its port.
  [[nodiscard]] std::uint64_t clocks() const { return periods_.count(); }

  /// Those after the last mark has entered.
  [[nodiscard]] std::uint64_t drain_clocks() const { return drain_clocks_; }

  /// Of the refresh port of that chain.
  [[nodiscard]] const LineClocks& clocks(std::size_t chain) const { return chains_[chain]; }

  /// For waves: of the chain, whose pixels are at the port or come next.
  [[nodiscard]] std::size_t line_of(std::size_t chain) const { return line_of_chain_[chain]; }

  /// The first of those whose last pixel came last.
  [[nodiscard]] std::size_t last_chain() const { return last_chain_; }

  /// Of each line the pixels from left to right; the lines in the frame's order.
  [[nodiscard]] const std::vector<std::vector<std::uint32_t>>& lines() const { return lines_; }

 private:
  void on_clock() override;
  void look_at(std::size_t chain);
  void collect(std::size_t chain, std::uint32_t colour);
  [[nodiscard]] bool any_enters() const;

  PictureLines frame_;
  bool active_ = false;
  Periods periods_;
  std::uint64_t drain_clocks_ = 0;
  std::vector<std::vector<std::uint32_t>> lines_;
  std::vector<std::size_t> line_of_chain_;  ///< whose pixels come
  std::vector<LineClocks> chains_;
  std::size_t last_chain_ = 0;
  std::uint64_t last_pixel_ = 0;  ///< clock in which it came
  std::size_t missing_lines_ = 0;
  std::uint64_t frames_done_ = 0;
};

}  // namespace csgsim::scan_line
