#pragma once

#include <cstdint>
#include <systemc>

#include "hw/array/sequencer.h"
#include "hw/pixel_planes/words.h"

namespace csgsim::pixel_planes {

/// What the controller is at, for waves.
struct ControllerStatus {
  bool busy = false;          ///< with an instruction
  std::uint64_t ordinal = 0;  ///< of the instruction within the program
  isa::Instruction instruction;
  std::uint32_t bit = 0;     ///< of the stream or field, the first of the step on the wires
  std::uint32_t pass = 0;    ///< of a stream that is sent twice, or of a memory read
  std::uint64_t clocks = 0;  ///< since the program's first step
};

/// Takes instructions from the host and issues a bit step at each rising edge. An instruction's clocks are the clock
/// periods in which one of its steps is on the wires, and, for a question, those until the answer has come. If
/// instructions are to be skipped then, it drops what the link holds and jumps: the host goes on from another place
/// within the same clock period. After the end word it waits `latency` clocks for the last step to reach the pixels.
class Controller final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_fifo_in<HostWord> link{"link"};
  sc_core::sc_fifo_out<std::uint64_t> jumps{"jumps"};  ///< ordinals of instructions that the host has to go on from
  sc_core::sc_in<Answer> answer{"answer"};
  sc_core::sc_out<RootWord> root{"root"};
  sc_core::sc_out<ControlWord> control{"control"};
  sc_core::sc_fifo_out<Account> accounts{"accounts"};
  sc_core::sc_out<std::uint64_t> programs{"programs"};  ///< carried out to their end

  /// `latency`: clocks from the roots of the multiplier trees to the pixels.
  Controller(sc_core::sc_module_name name, const array::Sequencer& sequencer, unsigned latency);

  /// Clocks counted for the program that is running or ran last, the final latency included.
  [[nodiscard]] std::uint64_t clocks() const { return status_.clocks; }
  [[nodiscard]] const ControllerStatus& status() const { return status_; }

 private:
  enum class State : std::uint8_t { idle, issuing, waiting, jumping, draining };

  void on_clock();
  void fetch();
  void issue();
  void rest();
  void take_answer();
  void jump(std::uint64_t skipped);
  void drain();

  const unsigned latency_;
  array::Sequencer sequencer_;
  State state_ = State::idle;
  ControllerStatus status_;
  std::uint64_t instruction_clocks_ = 0;
  unsigned drained_ = 0;
  std::uint64_t programs_done_ = 0;
};

}  // namespace csgsim::pixel_planes
