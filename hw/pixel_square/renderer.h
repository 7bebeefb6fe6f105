#pragma once

#include <cstdint>
#include <deque>
#include <systemc>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/activity_counter.h"
#include "hw/pixel_square/output_buffer.h"
#include "hw/pixel_square/retirement.h"
#include "hw/pixel_square/words.h"

namespace csgsim::pixel_square {

/// Draws one square after another on an array of bit-serial pixel processors. An instruction's first step is issued in
/// the clock that takes it from the FIFO; a step reaches the pixels when its bits have passed the multiplier trees, and
/// the end word travels behind the last step, a clock of its own. In the clock in which it arrives, the finished square
/// moves to the output buffer if that is free; without a second buffer it leaves from the pixels' own memory, and the
/// next square waits. Memory and registers are 0 when a square begins.
class Renderer final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<InstructionWord> link{"link"};
  sc_core::sc_fifo_out<ColourWord> colours{"colours"};
  sc_core::sc_out<std::uint64_t> finished{"finished"};  ///< squares that have left, or are in the output buffer
  sc_core::sc_port<RetirementPort> retirement{"retirement"};

  Renderer(sc_core::sc_module_name name, const machines::Machine& machine);

  /// `colour`: what of a pixel's memory goes to the frame buffer.
  void begin(isa::Field colour);

  /// Of the pixel processors. Clocks after the last square are `done`.
  [[nodiscard]] machines::SquareClocks account() const;
  [[nodiscard]] std::uint64_t squares() const { return squares_; }

 private:
  enum class State : std::uint8_t {
    drawing,   ///< takes instructions
    draining,  ///< the end word is on its way to the pixels
    drawn,     ///< the output buffer is not free
    moving,    ///< the square leaves from the pixels' memory
  };

  /// Broadcast to the pixels.
  struct ControlWord {
    array::ArrayStep step;
    bool last = false;  ///< of its instruction
    bool end = false;   ///< of the square
  };

  void on_clock();
  void send();
  machines::SquareActivity draw(bool output_free);
  machines::SquareActivity issue(bool output_free);
  bool fetch(ControlWord& word);
  void begin_square(const Square& square);
  void step(const array::RootBits& root, const ControlWord& word, bool output_free);
  void obey(const ControlWord& word, bool output_free);
  void retire();
  void move_out();
  void finish();

  const bool buffered_;
  array::Sequencer sequencer_;
  array::LinearEvaluator trees_;
  array::Words leaves_;
  array::PixelArray pixels_;
  OutputBuffer output_;
  std::vector<ControlWord> delay_;  ///< a ring as long as the trees
  std::size_t oldest_ = 0;

  isa::Field colour_;
  State state_ = State::drawing;
  bool in_square_ = false;
  Square square_;
  std::uint64_t instruction_clocks_ = 0;  ///< issued of the instruction at hand
  std::deque<std::uint64_t> issued_;      ///< clocks of the instructions on their way to the pixels
  std::uint32_t retired_ = 0;             ///< instructions of the square
  std::uint64_t enabled_ = 0;
  std::uint64_t finished_count_ = 0;
  std::uint64_t squares_ = 0;
  std::uint64_t idle_ = 0;  ///< clocks since the last square
  ActivityCounter counter_;
};

}  // namespace csgsim::pixel_square
