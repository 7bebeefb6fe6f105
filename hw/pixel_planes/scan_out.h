#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/array/plane.h"
#include "hw/isa/instruction.h"
#include "hw/pixel_planes/pixel_processors.h"

namespace csgsim::pixel_planes {

/// Refreshes the screen from the finished frame. A row's colour bits are latched through the refresh port, one bit of
/// all its pixels a clock; then the row is shifted out, one pixel a clock, while the next is latched. A frame of H rows
/// of W pixels of b bits takes b + (H - 1) * max(W, b) + W clocks.
class ScanOut final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_port<RefreshPort> refresh{"refresh"};
  sc_core::sc_out<std::uint32_t> video{"video"};
  sc_core::sc_out<std::uint64_t> frames{"frames"};  ///< scanned out

  ScanOut(sc_core::sc_module_name name, array::PlaneShape shape);

  /// Starts with the next clock.
  void begin(isa::Field colour);

  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }

  /// The colours shifted out since begin, in row order.
  [[nodiscard]] const std::vector<std::uint32_t>& picture() const { return picture_; }

 private:
  void on_clock();
  void transfer();
  void shift();
  void latch();

  array::PlaneShape shape_;
  isa::Field colour_;
  std::uint32_t row_ = 0;                 ///< being latched
  std::uint32_t latched_ = 0;             ///< bits of it
  std::vector<std::uint32_t> latch_row_;  ///< a colour a pixel
  std::vector<std::uint32_t> shift_row_;  ///< a colour a pixel
  std::uint32_t shifted_;                 ///< pixels of it
  std::uint64_t clocks_ = 0;
  std::uint64_t frames_done_ = 0;
  std::vector<std::uint32_t> picture_;
  sc_core::sc_event start_{"start"};
};

}  // namespace csgsim::pixel_planes
