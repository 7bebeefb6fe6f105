#pragma once

#include <cstdint>
#include <optional>

#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// Models how the screen reads the memory into which squares are drawn. The turns in which it reads are spread evenly
/// over the display time of a picture. Each turn copies the next `Figures::refresh_bits` bits of the picture to a
/// register from which they are shown. With two pictures, the screen reads the other picture and takes no turns of this
/// memory.
class Screen {
 public:
  Screen(const Figures& figures, std::uint64_t clock_hz);

  /// Begins a frame and the display of its picture.
  void begin(const machines::Size& picture, std::uint32_t colour_bits);

  /// Advances by `clocks` edges, at most clocks_to_change().
  void advance(std::uint64_t clocks);

  /// Edges until a turn begins or ends; valid only if takes_turns().
  [[nodiscard]] std::uint64_t clocks_to_change() const;

  /// First row that is read by the turn in the clock after the current edge; empty if that clock belongs to no turn.
  [[nodiscard]] std::optional<std::uint32_t> row() const;

  /// Whether the screen takes turns.
  [[nodiscard]] bool takes_turns() const { return step_ > 0; }

 private:
  const std::uint64_t rate_;      ///< pictures per second; 0 for none
  const std::uint64_t clock_hz_;  ///< clocks per second
  const std::uint64_t bits_;      ///< bits per turn
  const std::uint32_t clocks_;    ///< clocks per turn
  std::uint64_t picture_bits_ = 0;
  std::uint64_t row_bits_ = 1;
  std::uint64_t step_ = 0;   ///< turns per second
  std::uint64_t phase_ = 0;  ///< progress to the next turn, in turns per second x clocks
  std::uint64_t next_ = 0;   ///< first picture bit of the next turn
  std::uint64_t at_ = 0;     ///< first picture bit of the current turn
  std::uint32_t left_ = 0;   ///< remaining clocks of the current turn
};

/// Number of turns in which the screen reads a whole picture once.
std::uint64_t turns_per_picture(const machines::Size& picture, std::uint32_t colour_bits, const Figures& figures);

/// Throws InputError if the screen would occupy every clock of the memory.
void check_screen(const isa::FrameHeader& header, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
