#pragma once

#include <cstdint>
#include <optional>

#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// What the screen takes of the memory into which squares are drawn: turns, spread evenly over the time of a picture,
/// in each of which `Figures::refresh_bits` of it go to a register, row by row, and are shown from there. With two
/// pictures the screen reads the other one, and takes none.
class Screen {
 public:
  Screen(const Figures& figures, std::uint64_t clock_hz);

  /// A frame begins, and with it the time of a picture.
  void begin(const machines::Size& picture, std::uint32_t colour_bits);

  /// So many edges of the clock, at most as many as there are until the next change.
  void on_clocks(std::uint64_t clocks);

  /// Edges until a turn begins or ends; of a screen that takes turns.
  [[nodiscard]] std::uint64_t clocks_to_change() const;

  /// Of a turn in the clock that begins with the edge: the row in which it reads first.
  [[nodiscard]] std::optional<std::uint32_t> row() const;

  /// Whether it takes any turn.
  [[nodiscard]] bool takes() const { return step_ > 0; }

 private:
  const std::uint64_t rate_;      ///< pictures a second; 0 for none
  const std::uint64_t clock_hz_;  ///< clocks a second
  const std::uint64_t bits_;      ///< of a turn
  const std::uint32_t clocks_;    ///< of a turn
  std::uint64_t picture_bits_ = 0;
  std::uint64_t row_bits_ = 1;
  std::uint64_t step_ = 0;   ///< turns a second
  std::uint64_t phase_ = 0;  ///< of them, since the last has come due
  std::uint64_t next_ = 0;   ///< bit of the picture with which the next turn begins
  std::uint64_t at_ = 0;     ///< the same of the turn at hand
  std::uint32_t left_ = 0;   ///< clocks of it
};

/// Turns in which the screen shows that picture once.
std::uint64_t turns_of(const machines::Size& picture, std::uint32_t colour_bits, const Figures& figures);

/// Throws InputError if the screen takes every clock of the memory, or more.
void check_screen(const isa::FrameHeader& header, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
