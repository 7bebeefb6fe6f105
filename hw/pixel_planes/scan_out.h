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

/// Shows each picture that the controller has finished, once. A row's colour bits are latched, one bit of all its
/// pixels at a time; then the row is shifted out, `pixels` a clock, while the next is latched. At a port of its own a
/// bit is latched in each clock. At a shared port it asks the controller for each bit, one a clock; the bit is latched
/// in the clock in which the refresh word is at the pixels.
class ScanOut final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<FinishedPicture> pictures{"pictures"};
  sc_core::sc_port<RefreshPort> refresh{"refresh"};
  sc_core::sc_fifo_out<RefreshStep> refreshes{"refreshes"};  ///< to the controller
  sc_core::sc_fifo_out<bool> latched{"latched"};             ///< to the controller: one when a last row is latched
  sc_core::sc_out<std::uint64_t> frames{"frames"};           ///< scanned out

  /// `period`: of the clock.
  ScanOut(sc_core::sc_module_name name, const sc_core::sc_time& period, array::PlaneShape shape, std::uint32_t pixels,
          ScanOutPort port);

  // For waves.
  [[nodiscard]] bool is_showing() const { return state_ == State::showing; }
  [[nodiscard]] std::uint32_t row_latched() const { return row_; }  ///< that is being latched
  [[nodiscard]] std::uint32_t video() const;                        ///< the last of the pixels that have been shown

  /// Of the picture that is being shown, or was last: the colours shifted out, in row order.
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
  void ask();
  void latch_bit(RefreshStep step);

  const sc_core::sc_time period_;
  array::PlaneShape shape_;
  const std::uint32_t pixels_;
  const ScanOutPort port_;
  isa::Field colour_;
  std::uint32_t row_ = 0;                 ///< being latched
  std::uint32_t asked_ = 0;               ///< bits of it that the controller has been asked for
  std::uint32_t latched_ = 0;             ///< bits of it
  std::vector<std::uint32_t> latch_row_;  ///< a colour a pixel
  std::vector<std::uint32_t> shift_row_;  ///< a colour a pixel
  std::uint32_t shifted_;                 ///< pixels of it
  std::uint64_t frames_done_ = 0;
  State state_ = State::asleep;  ///< asleep until a picture comes; awake, it looks for one at the next edge
  std::vector<std::uint32_t> picture_;
  std::uint32_t video_ = 0;     ///< as it was at the last edge at which it acted
  std::uint64_t acted_at_ = 0;  ///< that edge
};

}  // namespace csgsim::pixel_planes
