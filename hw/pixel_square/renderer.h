#pragma once

#include <cstdint>
#include <deque>
#include <systemc>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/isa/wire.h"
#include "hw/link/receiver.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/output_buffer.h"
#include "hw/pixel_square/port_word.h"
#include "hw/pixel_square/square_names.h"
#include "hw/systemc/retirement.h"

namespace csgsim::pixel_square {

/// Draws one square after another on an array of bit-serial pixel processors.
///
/// A receiver takes a word a clock from the FIFO, until it has a whole command. The pixels' controller takes that in
/// the clock after its last word, if it is through with the one before; in that clock the next command's first word
/// comes. SegmentStart takes the clocks that clear the memory, one at least. An instruction's first step is issued in
/// the clock that takes it; a step reaches the pixels when its bits have passed the multiplier trees. SegmentEnd
/// travels behind the last step, a clock of its own. In the clock after it has arrived, or in which the output buffer
/// has become free, the finished square begins to move there, so many bit planes a clock; all planes at once take no
/// clock. Without a second buffer the square leaves from the pixels' own memory, and the next waits.
class Renderer final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<isa::LinkWord> link{"link"};
  sc_core::sc_fifo_out<PortWord> colours{"colours"};
  sc_core::sc_out<std::uint64_t> finished{"finished"};  ///< squares that have left, or are in the output buffer
  sc_core::sc_port<kernel::RetirementPort> retirement{"retirement"};

  Renderer(sc_core::sc_module_name name, const machines::Machine& machine);

  /// `colour`: what of a pixel's memory goes to the frame buffer. The names have to live until the frame is drawn.
  void begin(isa::Field colour, const SquareNames& names);

  /// Of the pixel processors. Clocks after the last square are `done`.
  [[nodiscard]] SquareClocks account() const;
  [[nodiscard]] std::uint64_t squares() const { return squares_; }

 private:
  enum class State : std::uint8_t {
    idle,      ///< waits for a square
    clearing,  ///< the pixels' memory
    drawing,   ///< takes instructions
    draining,  ///< the end is on its way to the pixels
    drawn,     ///< the output buffer is not free
    moving,    ///< the square moves to the output buffer
    leaving,   ///< the square leaves from the pixels' memory
  };

  /// Broadcast to the pixels.
  struct ControlWord {
    array::ArrayStep step;
    bool last = false;  ///< of its instruction
    bool end = false;   ///< of the square
  };

  void on_clock();
  void send();
  SquareActivity draw(bool output_free);
  SquareActivity issue(bool output_free);
  bool fetch(ControlWord& word);
  void begin_square(const isa::SegmentStart& start);
  SquareActivity clear();
  void step(const array::RootBits& root, const ControlWord& word, bool output_free);
  void obey(const ControlWord& word, bool output_free);
  void retire();
  void move_out();
  void finish();

  const bool buffered_;
  const std::uint32_t clear_clocks_;
  const std::uint32_t move_bits_;
  link::Receiver receiver_;
  array::Sequencer sequencer_;
  array::LinearEvaluator trees_;
  array::Words leaves_;
  array::PixelArray pixels_;
  OutputBuffer output_;
  std::vector<ControlWord> delay_;  ///< a ring as long as the trees
  std::size_t oldest_ = 0;

  isa::Field colour_;
  State state_ = State::idle;
  isa::Region region_;                    ///< of the square at hand
  std::uint32_t clocks_left_ = 0;         ///< of clearing or moving
  std::uint64_t instruction_clocks_ = 0;  ///< issued of the instruction at hand
  std::deque<std::uint64_t> issued_;      ///< clocks of the instructions on their way to the pixels
  std::uint64_t finished_count_ = 0;
  std::uint64_t squares_ = 0;
  std::uint64_t idle_ = 0;  ///< clocks since the last square
  SquareClocks clocks_;

  const SquareNames* names_ = nullptr;
  std::uint32_t segment_ = 0;  ///< that the square is
  std::uint32_t retired_ = 0;  ///< instructions of the square
  std::uint64_t enabled_ = 0;
};

}  // namespace csgsim::pixel_square
