#include "hw/pixel_planes/controller.h"

#include "hw/isa/operands.h"

namespace csgsim::pixel_planes {

Controller::Controller(sc_core::sc_module_name name, const array::Sequencer& sequencer, unsigned latency)
    : sc_core::sc_module(name), latency_(latency), sequencer_(sequencer) {
  SC_HAS_PROCESS(Controller);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

/// Runs at the edge, and once more within the clock period when the first word after a jump has come.
void Controller::on_clock() {
  if (state_ == State::jumping) state_ = State::issuing;
  if (state_ == State::waiting) take_answer();
  if (state_ == State::jumping) return next_trigger(link->data_written_event());
  if (state_ == State::idle || (state_ == State::issuing && !sequencer_.busy())) fetch();
  switch (state_) {
    case State::idle: break;
    case State::issuing: sequencer_.busy() ? issue() : rest(); break;
    case State::waiting: rest(); break;
    case State::jumping: break;
    case State::draining: drain(); break;
  }
}

void Controller::fetch() {
  HostWord word;
  if (!link.nb_read(word)) return;
  if (state_ == State::idle) status_.clocks = 0;
  if (word.end) {
    state_ = State::draining;
    drained_ = 0;
    status_.busy = false;
    return;
  }
  state_ = State::issuing;
  sequencer_.begin(word.instruction);
  instruction_clocks_ = 0;
  status_.busy = true;
  status_.ordinal = word.ordinal;
  status_.instruction = word.instruction;
}

/// Puts the next bit step on the wires for the clock period that begins now.
void Controller::issue() {
  status_.bit = sequencer_.bit();
  status_.pass = sequencer_.pass();
  const array::BitStep step = sequencer_.issue();
  root.write({step.root});
  control.write({.step = step.pixels, .last = step.last, .ordinal = status_.ordinal});
  ++status_.clocks;
  ++instruction_clocks_;
  if (step.pixels.function == array::AluFunction::answer) {
    state_ = State::waiting;
  } else if (step.last) {
    accounts.nb_write({.clocks = instruction_clocks_});
  }
}

void Controller::rest() {
  root.write({});
  control.write({});
  ++status_.clocks;
  ++instruction_clocks_;
}

void Controller::take_answer() {
  if (!answer.read().valid) return;
  const isa::Instruction& question = status_.instruction;
  const bool any_enabled = answer.read().any_enabled;
  const std::uint64_t skipped = isa::skipped_after(question, any_enabled ? 1 : 0);
  accounts.nb_write({.clocks = instruction_clocks_,
                     .answered = question.opcode == isa::Opcode::global_or,
                     .answer = any_enabled,
                     .skipped = skipped});
  state_ = State::issuing;
  if (skipped > 0) jump(skipped);
}

void Controller::jump(std::uint64_t skipped) {
  HostWord dropped;
  while (link.nb_read(dropped)) continue;
  jumps.nb_write(status_.ordinal + 1 + skipped);
  state_ = State::jumping;
}

void Controller::drain() {
  root.write({});
  control.write({});
  if (drained_ == latency_) {
    state_ = State::idle;
    programs.write(++programs_done_);
    return;
  }
  ++drained_;
  ++status_.clocks;
}

}  // namespace csgsim::pixel_planes
