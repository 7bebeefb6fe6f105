#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <systemc>

#include "hw/systemc/retirement.h"

namespace csgsim::scan_line {

/// Where a chain tells what its cells have carried out. Lines of a frame may enter while lines of the one before are in
/// the cells: the entry asks the listener of the last frame that has begun, the cells tell that of the first of which
/// lines are left.
class LineRetirement final : public sc_core::sc_module, public systemc::RetirementPort {
 public:
  explicit LineRetirement(sc_core::sc_module_name name);

  /// A frame begins, of which the chain draws so many lines. The listener has to live until they are drawn.
  void begin(systemc::RunListener& listener, std::size_t lines);

  [[nodiscard]] systemc::Keep keeps_after(std::uint32_t segment, std::uint32_t index) override;
  void after_instruction(const systemc::Retired& retired, const systemc::PixelView& pixels) override;
  void after_segment(std::uint32_t segment, const systemc::PixelView& pixels) override;

 private:
  struct Frame {
    systemc::RunListener* listener;
    std::size_t lines_left;
  };
  std::deque<Frame> frames_;  ///< of which lines are left
};

}  // namespace csgsim::scan_line
