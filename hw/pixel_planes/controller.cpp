#include "hw/pixel_planes/controller.h"

namespace csgsim::pixel_planes {

Controller::Controller(sc_core::sc_module_name name, const array::Sequencer& sequencer, unsigned latency)
    : sc_core::sc_module(name), latency_(latency), sequencer_(sequencer) {
  SC_HAS_PROCESS(Controller);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

void Controller::on_clock() {
  if (state_ == State::waiting) take_answer();
  if (state_ == State::idle || (state_ == State::issuing && !sequencer_.busy())) fetch();
  switch (state_) {
    case State::idle: break;
    case State::issuing: sequencer_.busy() ? issue() : rest(); break;
    case State::waiting: rest(); break;
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
  accounts.nb_write({.clocks = instruction_clocks_, .answered = true, .answer = answer.read().any_enabled});
  state_ = State::issuing;
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
