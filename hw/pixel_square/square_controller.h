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

/// Takes commands from the link and puts a control word on the wires at each rising edge, for the clock that begins
/// with it. SegmentStart takes the clocks that clear the memory, one at least; an instruction those in which one of its
/// steps is on the wires; SegmentEnd one, and those in which the last step is on its way to the pixels. From the next
/// edge on at which the output buffer is free the square moves there, so many bit planes a clock; all planes at once
/// take no clock. With a backing store it moves as soon as that has room for it, so many bits a clock. Without a second
/// buffer or a backing store the pixels wait until it has left. Then the next command is taken.
///
/// A question takes its step's clock and those until the answer is there. If no pixel is enabled, as many instructions
/// as it says are dropped when they have come, each in the clock in which the next command could have been taken.
class SquareController final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<isa::LinkWord> link{"link"};
  sc_core::sc_in<pixel_planes::Answer> answer{"answer"};
  sc_core::sc_in<std::uint64_t> left{"left"};  ///< squares whose last word has left for the frame buffer
  sc_core::sc_port<pixel_planes::PixelWires> wires{"wires"};
  sc_core::sc_out<std::uint64_t> begun{"begun"};        ///< squares that have begun to move or to leave
  sc_core::sc_out<std::uint64_t> header{"header"};      ///< of the last of these
  sc_core::sc_out<bool> moving{"moving"};               ///< it is not whole in the output buffer
  sc_core::sc_out<std::uint64_t> finished{"finished"};  ///< squares that have left, or are in the output buffer
  sc_core::sc_fifo_out<CommandAccount> accounts{"accounts"};

  SquareController(sc_core::sc_module_name name, const machines::Machine& machine);

  /// A frame begins, with colours of so many bits.
  void begin(std::uint32_t colour_bits);

  /// Of a frame of so many clocks, those that are over. Those after the last square are `done`.
  [[nodiscard]] SquareClocks account(std::uint64_t clocks) const {
    return whole(clocks_, SquareActivity::done, clocks);
  }
  [[nodiscard]] std::uint64_t squares() const { return squares_; }

  // For waves.
  [[nodiscard]] std::string_view state() const;
  /// Of the square at hand.
  [[nodiscard]] std::optional<isa::Region> square() const {
    return state_ == State::idle ? std::nullopt : std::optional(region_);
  }

 private:
  enum class State : std::uint8_t {
    idle,      ///< waits for a square
    clearing,  ///< the pixels' memory
    drawing,   ///< takes instructions
    asking,    ///< waits for the answer to a question
    draining,  ///< the last step is on its way to the pixels
    drawn,     ///< the output buffer is not free
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
  void rest();
  void sleep();
  void sleep(std::uint64_t clocks);
  std::uint64_t clear_ahead();
  std::uint64_t issue_ahead();
  /// Steps of an instruction are still to be put.
  [[nodiscard]] bool is_issuing() const { return last_step_ || sequencer_.busy(); }
  void put(const pixel_planes::ControlWord& word, const array::RootBits& bits = {});
  void put_step(const array::BitStep& step);

  const sc_core::sc_time period_;
  const Figures figures_;
  const std::uint32_t clear_clocks_;
  const std::uint32_t memory_bits_;
  const std::uint32_t latency_;  ///< from the roots of the multiplier trees to the pixels
  const std::uint64_t pixels_;
  link::Receiver receiver_;
  array::Sequencer sequencer_;
  std::uint64_t move_clocks_ = 0;
  std::uint64_t waiting_ = 0;  ///< squares that may, besides the one that is drawn; 0: they leave from the pixels

  State state_ = State::idle;
  SquareActivity activity_ = SquareActivity::waiting_for_divider;  ///< in the clock that began last
  isa::Region region_;                                             ///< of the square at hand
  std::uint64_t clocks_left_ = 0;                                  ///< of clearing, of draining or of moving
  std::uint64_t instruction_clocks_ = 0;                           ///< of the instruction at hand
  std::uint64_t skips_left_ = 0;                                   ///< instructions that are to be dropped
  std::uint64_t ordinal_ = 0;                ///< of the instruction that comes next, within the square
  bool resting_ = true;                      ///< the wires carry no step
  std::uint64_t acted_at_ = 0;               ///< edge
  std::uint64_t put_at_ = 0;                 ///< edge from which the wires carry what is put next
  std::optional<array::BitStep> last_step_;  ///< of the instruction at hand, when those before it have been put
  sc_core::sc_event_or_list left_or_word_;   ///< a square has left, or a word has come
  std::uint64_t begun_count_ = 0;
  std::uint64_t finished_count_ = 0;
  std::uint64_t squares_ = 0;
  std::uint64_t idle_from_ = 0;  ///< edge of the last square's last clock, or the frame's first
  SquareClocks clocks_;
};

}  // namespace csgsim::pixel_square
