#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <systemc>

#include "hw/systemc/retirement.h"

namespace csgsim::scan_line {

/// Forwards the reports of a chain's cells to the run listeners. Lines of a frame may enter while lines of the previous
/// frame are in the cells: the entry queries the listener of the newest frame; the cells report to the listener of the
/// oldest frame that has lines left.
class LineRetirement final : public sc_core::sc_module, public systemc::RetirementPort {
 public:
  explicit LineRetirement(sc_core::sc_module_name name);

  /// Begins a frame; the chain draws `line_count` of its lines. The listener must outlive the frame.
  void begin(systemc::RunListener& listener, std::size_t line_count);

  [[nodiscard]] systemc::Keep required_after(std::uint32_t segment, std::uint32_t index) override;
  void after_instruction(const systemc::Retired& retired, const systemc::PixelView& pixels) override;
  void after_segment(std::uint32_t segment, const systemc::PixelView& pixels) override;

 private:
  struct Frame {
    systemc::RunListener* listener;
    std::size_t lines_left;
  };
  std::deque<Frame> frames_;  ///< frames that have lines left
};

}  // namespace csgsim::scan_line
