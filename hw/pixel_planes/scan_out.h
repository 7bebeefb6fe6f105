// The scan-out of a frame buffer.
// Used by the Pixel-planes machine.
#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/array/plane.h"
#include "hw/isa/instruction.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/pixel_ports.h"

namespace csgsim::pixel_planes {

/// Shows each finished picture once. It latches the colour bits of a row, one bit of all its pixels at a time, and then
/// shifts the row out, several pixels per clock, while it latches the next row. With its own port it latches a bit in
/// each clock. With a shared port it requests each bit from the controller, one per clock, and latches the bit in the
/// clock in which the refresh word is at the pixels.
class ScanOut final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<FinishedPicture> pictures{"pictures"};
  sc_core::sc_port<RefreshPort> refresh{"refresh"};
  sc_core::sc_fifo_out<RefreshStep> refreshes{"refreshes"};  ///< requests to the controller
  sc_core::sc_fifo_out<bool> latched{"latched"};             ///< to the controller: one token per latched picture
  sc_core::sc_out<std::uint64_t> frames{"frames"};           ///< number of pictures scanned out

  /// `period`: clock period.
  ScanOut(sc_core::sc_module_name name, const sc_core::sc_time& period, array::PlaneShape shape,
          std::uint32_t pixels_per_clock, ScanOutPort port);

  // State for waves.
  [[nodiscard]] bool is_showing() const { return state_ == State::showing; }
  [[nodiscard]] std::uint32_t row_latched() const { return row_; }  ///< row being latched
  [[nodiscard]] std::uint32_t video() const;                        ///< colour of the last pixel shown

  /// Colours shifted out of the current or last picture, in row order.
  [[nodiscard]] const std::vector<std::uint32_t>& picture() const { return picture_; }

 private:
  enum class State : std::uint8_t { asleep, awake, showing };

  void on_clock();
  void wake();
  bool begin();
  void act();
  void transfer();
  void shift(std::uint64_t clocks);
  void sleep();
  [[nodiscard]] bool latches() const { return row_ != shape_.height && latched_ != colour_.width; }
  void latch();
  void request_bit();
  void latch_refresh_bit(RefreshStep refresh_step);

  const sc_core::sc_time period_;
  array::PlaneShape shape_;
  const std::uint32_t pixels_;
  const ScanOutPort port_;
  isa::Field colour_;
  std::uint32_t row_ = 0;                 ///< row being latched
  std::uint32_t requested_ = 0;           ///< number of bits of the row requested from the controller
  std::uint32_t latched_ = 0;             ///< number of bits of the row latched
  std::vector<std::uint32_t> latch_row_;  ///< one colour per pixel
  std::vector<std::uint32_t> shift_row_;  ///< one colour per pixel
  std::uint32_t shifted_;                 ///< pixels of shift_row_ shown
  std::uint64_t frames_done_ = 0;
  State state_ = State::asleep;  ///< `asleep` until a picture arrives; `awake`: takes a picture at the next edge
  std::vector<std::uint32_t> picture_;
  std::uint32_t video_ = 0;     ///< colour of the last pixel shown at acted_at_
  std::uint64_t acted_at_ = 0;  ///< edge of the last action
};

}  // namespace csgsim::pixel_planes
