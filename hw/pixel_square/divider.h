#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/activity_counter.h"
#include "hw/pixel_square/words.h"

namespace csgsim::pixel_square {

/// What the divider has to do for a frame.
struct Division {
  std::span<const isa::Segment> segments;  ///< the squares, in order
  std::uint64_t model_words = 0;           ///< that the host sends
  std::uint64_t primitives = 0;            ///< of the model: each is held against each square
};

/// Takes the model from the host, then for each square tests it, and hands the square's instructions, a word a clock
/// and an end word after them, to the renderer with the fewest squares that it has not finished (the first of those). A
/// square without instructions is cleared in the frame buffer.
class Divider final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<ModelWord> model{"model"};
  sc_core::sc_vector<sc_core::sc_fifo_out<InstructionWord>> links;  ///< one a renderer
  sc_core::sc_vector<sc_core::sc_in<std::uint64_t>> finished;       ///< squares that each renderer has finished
  sc_core::sc_fifo_out<ClearWord> clears{"clears"};

  Divider(sc_core::sc_module_name name, const machines::PixelSquare& figures);

  /// Starts at the next edge. The segments have to live until the frame is drawn.
  void begin(const Division& division);

  [[nodiscard]] const machines::SquareClocks& account() const { return counter_.clocks(); }
  [[nodiscard]] std::uint64_t squares_skipped() const { return skipped_; }

 private:
  void on_clock();
  machines::SquareActivity act();
  machines::SquareActivity take_model();
  machines::SquareActivity clear();
  machines::SquareActivity send();
  void begin_square(std::size_t square);
  [[nodiscard]] std::size_t least_busy() const;

  const std::uint64_t primitive_clocks_;
  const std::uint64_t halfspace_clocks_;
  Division division_;
  std::size_t square_ = 0;
  std::uint64_t tests_left_ = 0;       ///< clocks of testing the square
  std::size_t index_ = 0;              ///< of the instruction to send
  std::optional<std::size_t> target_;  ///< the renderer that gets the square
  std::vector<std::uint64_t> handed_;  ///< squares that each renderer has got
  std::uint64_t skipped_ = 0;
  ActivityCounter counter_;
};

}  // namespace csgsim::pixel_square
