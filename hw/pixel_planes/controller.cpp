#include "hw/pixel_planes/controller.h"

#include <algorithm>
#include <variant>

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/pixel_planes/clear_step.h"

namespace csgsim::pixel_planes {

Controller::Controller(sc_core::sc_module_name name, const array::Sequencer& sequencer,
                       const ControllerFigures& figures)
    : sc_core::sc_module(name), figures_(figures), sequencer_(sequencer), receiver_(figures.link_width) {
  SC_HAS_PROCESS(Controller);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

void Controller::begin() {
  state_ = State::asking;
  status_ = {};
  account_ = {};
  next_ordinal_ = 0;
  instructions_ = 0;
}

void Controller::on_clock() {
  if (state_ == State::idle) {
    if (!refresh()) rest();
    return;
  }
  if (state_ == State::waiting) take_answer();
  if (state_ == State::ready && receiver_.holds()) begin_command();
  put_control_word();
  receive();
}

/// For the clock period that begins now.
void Controller::put_control_word() {
  switch (state_) {
    case State::idle: return;
    case State::asking: ask(); [[fallthrough]];
    case State::ready:
      rest();
      status_.busy = false;
      ++(jumped_ ? account_.jumping : account_.starved);
      break;
    case State::issuing:
      issue();
      ++account_.issuing;
      break;
    case State::clearing:
      clear();
      ++account_.clearing;
      break;
    case State::waiting:
      rest();
      ++instruction_clocks_;
      ++account_.answering;
      break;
    case State::draining: return drain();
  }
  ++status_.clocks;
}

void Controller::ask() {
  requests.nb_write(0);
  state_ = State::ready;
}

void Controller::begin_command() {
  jumped_ = false;
  std::visit([this](const auto& command) { begin(command); }, receiver_.take());
}

void Controller::begin(const isa::Instruction& instruction) {
  state_ = State::issuing;
  sequencer_.begin(instruction);
  instruction_clocks_ = 0;
  ++instructions_;
  status_.busy = true;
  status_.ordinal = next_ordinal_++;
  status_.instruction = instruction;
}

void Controller::begin(const isa::SegmentStart& start) {
  state_ = State::clearing;
  region_ = start.region;
  cleared_ = 0;
  status_.busy = false;
}

/// Nothing is to be done: where a segment ends the next begins.
void Controller::begin(const isa::SegmentEnd& /*end*/) {}

void Controller::begin(const isa::FrameEnd& /*end*/) {
  state_ = State::draining;
  drained_ = 0;
  status_.busy = false;
}

void Controller::issue() {
  status_.bit = sequencer_.bit();
  status_.pass = sequencer_.pass();
  const array::BitStep step = sequencer_.issue();
  root.write({step.root});
  ControlWord word;
  word.step = step.pixels;
  word.last = step.last;
  word.ordinal = status_.ordinal;
  control.write(word);
  ++instruction_clocks_;
  if (step.pixels.function == array::AluFunction::answer) {
    state_ = State::waiting;
  } else if (step.last) {
    accounts.nb_write({.cleared = false, .clocks = instruction_clocks_});
    state_ = State::ready;
  }
}

void Controller::clear() {
  const std::uint32_t clocks = std::max(figures_.clear_clocks, 1U);
  const ClearStep step = clear_step(region_, figures_.memory_bits, cleared_, clocks, figures_.memory_bits);
  ++cleared_;
  const bool last = cleared_ == clocks;
  root.write({});
  ControlWord word;
  word.clears = true;
  word.clear = step;
  word.last = last;
  word.ordinal = next_ordinal_;
  control.write(word);
  if (!last) return;
  accounts.nb_write({.cleared = true});
  state_ = State::ready;
}

void Controller::rest() {
  root.write({});
  control.write({});
}

/// Puts a refresh word on the wires if the scan-out has asked for one.
bool Controller::refresh() {
  RefreshStep step;
  if (!refreshes.nb_read(step)) return false;
  root.write({});
  ControlWord word;
  word.refreshes = true;
  word.refresh = step;
  control.write(word);
  return true;
}

void Controller::take_answer() {
  if (!answer.read().valid) return;
  const isa::Instruction& question = status_.instruction;
  const bool any_enabled = answer.read().any_enabled;
  const std::uint64_t skipped = isa::skipped_after(question, any_enabled ? 1 : 0);
  accounts.nb_write({.cleared = false,
                     .clocks = instruction_clocks_,
                     .answered = question.opcode == isa::Opcode::global_or,
                     .answer = any_enabled,
                     .skipped = skipped});
  state_ = State::ready;
  if (skipped > 0) jump(skipped);
}

void Controller::jump(std::uint64_t skipped) {
  next_ordinal_ += skipped;
  requests.nb_write(next_ordinal_);
  receiver_.drop(link);
  edges_to_drop_ = 2;
  jumped_ = true;
}

void Controller::drain() {
  rest();
  if (drained_ == figures_.latency) {
    state_ = State::idle;
    programs.write(++programs_done_);
    return;
  }
  ++drained_;
  ++account_.draining;
  ++status_.clocks;
}

void Controller::receive() {
  if (edges_to_drop_ == 0) return receiver_.clock(link);
  --edges_to_drop_;
  receiver_.drop(link);
}

}  // namespace csgsim::pixel_planes
