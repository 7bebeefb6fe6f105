#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <systemc>

#include "hw/array/sequencer.h"
#include "hw/isa/wire.h"
#include "hw/link/receiver.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/pixel_ports.h"
#include "hw/pixel_square/account.h"
#include "hw/pixel_square/command_account.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

/// Receives commands from the link and puts a control word on the wires at each rising edge, for the clock that begins
/// with it.
/// - SegmentStart takes the clocks that clear the memory, at least one.
/// - An instruction takes the clocks in which its steps are on the wires.
/// - A global-OR test takes the clock of its step, and the clocks until its answer arrives. If no pixel is enabled, as
///   many instructions as the test specifies are received and dropped, each in the clock in which the next command
///   could have been taken.
/// - SegmentEnd takes one clock, and the clocks in which the last step travels to the pixels.
///
/// At the next edge at which the output buffer is free, the square starts to move into that buffer, `move_bits` bit
/// planes per clock; moving all planes at once takes no clock. With a backing store, the square moves as soon as the
/// store has room, `backing_width` bits per clock. With neither a second buffer nor a backing store, the pixels wait
/// until the square has left. Then the next command is taken.
class SquareController final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<isa::LinkWord> link{"link"};
  sc_core::sc_in<pixel_planes::Answer> answer{"answer"};
  sc_core::sc_in<std::uint64_t> left{"left"};  ///< squares whose last word has left for the frame buffer
  sc_core::sc_port<pixel_planes::PixelWires> wires{"wires"};
  sc_core::sc_out<std::uint64_t> begun{"begun"};    ///< squares that have begun to move or to leave
  sc_core::sc_out<std::uint64_t> header{"header"};  ///< header of the last of these
  /// Whether that square has not yet arrived completely in the output buffer.
  sc_core::sc_out<bool> moving{"moving"};
  /// Squares that have left, or are complete in the output buffer.
  sc_core::sc_out<std::uint64_t> finished{"finished"};
  sc_core::sc_fifo_out<CommandAccount> accounts{"accounts"};

  SquareController(sc_core::sc_module_name name, const machines::Machine& machine);

  /// Begins a frame with colours of `colour_bits` bits.
  void begin(std::uint32_t colour_bits);

  /// Clocks by activity in a completed frame of `clocks` clocks. Clocks after the last square are `done`.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const {
    return complete_clocks(clocks_, SquareActivity::done, clocks);
  }
  [[nodiscard]] std::uint64_t squares() const { return squares_; }

  // State for waves.
  [[nodiscard]] std::string_view state() const;
  /// Region of the square in progress.
  [[nodiscard]] std::optional<isa::Region> square() const {
    return state_ == State::idle ? std::nullopt : std::optional(region_);
  }

 private:
  enum class State : std::uint8_t {
    idle,      ///< waits for a square
    clearing,  ///< clears the pixels' memory
    drawing,   ///< executes instructions
    asking,    ///< waits for the answer of the global OR
    draining,  ///< the last step is on its way to the pixels
    drawn,     ///< waits for room in the output buffer
    moving,    ///< the square moves to the output buffer
    leaving,   ///< the square leaves from the pixels' memory
  };

  void end_of_elaboration() override;
  void act();
  std::uint64_t count();
  [[nodiscard]] std::uint64_t edges() const;
  void advance(std::uint64_t clocks);
  void take_answer();
  void begin_output();
  void finish();
  void put_control_word();
  void take_command();
  void begin_square(const isa::Region& region);
  void clear();
  void issue();
  void drain();
  void put_idle_word();
  void sleep();
  void sleep(std::uint64_t clocks);
  std::uint64_t clear_ahead();
  std::uint64_t issue_ahead();
  /// Whether steps of the current instruction remain to be issued.
  [[nodiscard]] bool is_issuing() const { return last_step_ || sequencer_.busy(); }
  void put(const pixel_planes::ControlWord& word, const array::RootBits& bits = {});
  void put_step(const array::BitStep& step);

  const sc_core::sc_time period_;
  const Figures figures_;
  const std::uint32_t clear_clocks_;
  const std::uint32_t memory_bits_;
  const std::uint32_t latency_;  ///< clocks from the roots of the multiplier trees to the pixels
  const std::uint64_t pixels_;
  link::Receiver receiver_;
  array::Sequencer sequencer_;
  std::uint64_t move_clocks_ = 0;
  std::uint64_t waiting_ = 0;  ///< squares that can wait in addition to the one being drawn; 0: squares leave from the
                               ///< pixels

  State state_ = State::idle;
  SquareActivity activity_ = SquareActivity::waiting_for_divider;  ///< activity of the clock that began last
  isa::Region region_;                                             ///< region of the current square
  std::uint64_t clocks_left_ = 0;                                  ///< remaining clocks of clearing, draining or moving
  std::uint64_t instruction_clocks_ = 0;                           ///< clocks of the current instruction
  std::uint64_t skips_left_ = 0;                                   ///< number of instructions still to be dropped
  std::uint64_t ordinal_ = 0;                                      ///< index of the next instruction within the square
  bool wires_idle_ = true;                                         ///< whether the wires carry no step
  std::uint64_t acted_at_ = 0;                                     ///< clock edge
  std::uint64_t put_at_ = 0;                                       ///< edge from which the wires carry the next word
  std::optional<array::BitStep> last_step_;  ///< last step of the current instruction, after the others have been
                                             ///< issued
  sc_core::sc_event_or_list left_or_word_;   ///< a square has left, or a word has arrived
  std::uint64_t begun_count_ = 0;
  std::uint64_t finished_count_ = 0;
  std::uint64_t squares_ = 0;
  std::uint64_t idle_from_ = 0;  ///< edge at which the controller became idle, or at which the frame began
  SquareClocks clocks_;
};

}  // namespace csgsim::pixel_square
