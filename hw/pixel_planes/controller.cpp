#include "hw/pixel_planes/controller.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/pixel_planes/clear_step.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_planes {

Controller::Controller(sc_core::sc_module_name name, const sc_core::sc_time& period, const array::Sequencer& sequencer,
                       const ControllerFigures& figures)
    : systemc::ClockedModule(name),
      period_(period),
      figures_(figures),
      sequencer_(sequencer),
      receiver_(figures.link_width) {}

/// Clock edges since construction.
std::uint64_t Controller::edges() const { return systemc::edges(period_); }

ControllerStatus Controller::status() const {
  ControllerStatus status = status_;
  const std::uint64_t elapsed = edges() - acted_at_;
  if (elapsed >= ahead_.size()) return status;
  status.bit = ahead_[elapsed].bit;
  status.pass = ahead_[elapsed].pass;
  status.clocks -= ahead_.size() - 1 - elapsed;
  return status;
}

void Controller::resume(const isa::Instruction& instruction, std::uint64_t ordinal, std::uint64_t first_clock) {
  state_ = State::ready;
  status_ = {};
  status_.clocks = first_clock;
  next_ordinal_ = ordinal;
  receiver_.put(instruction);
}

std::string_view Controller::state() const {
  constexpr auto names = std::to_array<std::string_view>(
      {"idle", "asking", "ready", "issuing", "clearing", "waiting", "holding", "copying", "draining"});
  return names.at(static_cast<std::size_t>(state_));
}

void Controller::end_of_elaboration() {
  begins_or_refreshes_ |= frames.data_written_event();
  begins_or_refreshes_ |= latched.data_written_event();
  begins_or_refreshes_ |= refreshes.data_written_event();
}

/// Sleeps while idle without requests, and while steps that are already on the wires pass.
void Controller::on_clock() {
  if (!clock.posedge()) return;
  act();
  if (state_ == State::issuing) issue_ahead();
  if (state_ == State::idle && resting_ && refreshes.num_available() == 0) next_trigger(begins_or_refreshes_);
}

void Controller::act() {
  acted_at_ = edges();
  ahead_.clear();
  if (bool token = false; latched.nb_read(token)) unlatched_ = false;
  if (state_ == State::idle) begin_frame();
  if (state_ == State::waiting) take_answer();
  refreshed_ = !has_control_wires() && refresh();
  if (state_ == State::ready && !refreshed_ && receiver_.holds()) begin_command();
  if (state_ == State::holding && !unlatched_) begin_copy();
  put_control_word();
  if (state_ != State::idle) receive();
}

void Controller::begin_frame() {
  bool token = false;
  if ((unlatched_ && !figures_.two_buffers) || !frames.nb_read(token)) return;
  state_ = State::asking;
  status_ = {};
  account_ = {};
  next_ordinal_ = 0;
  instructions_ = 0;
}

/// Whether the controller sends its own steps, which no refresh word may interrupt.
bool Controller::has_control_wires() const {
  return state_ == State::issuing || state_ == State::clearing || state_ == State::copying;
}

/// Puts a refresh word on the wires if the scan-out has requested one.
bool Controller::refresh() {
  RefreshStep step;
  if (!refreshes.nb_read(step)) return false;
  put({.refreshes = true, .refresh = step});
  return true;
}

/// Sets the wires for the clock period that begins now.
void Controller::put_control_word() {
  if (!refreshed_ && refreshes.num_available() > 0) ++account_.refresh_waits;
  switch (state_) {
    case State::idle:
      if (!refreshed_) put({});
      return;
    case State::asking: request_frame(); [[fallthrough]];
    case State::ready:
      status_.busy = false;
      count_waiting_clock(jumped_ ? account_.jumping : account_.starved);
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
      count_waiting_clock(account_.answering);
      ++instruction_clocks_;
      break;
    case State::holding: count_waiting_clock(account_.holding); break;
    case State::copying:
      copy();
      ++account_.copying;
      break;
    case State::draining:
      if (drained_ == figures_.latency) return finish();
      ++drained_;
      count_waiting_clock(account_.draining);
      break;
  }
  ++status_.clocks;
}

/// Spends a clock without a step of the controller. Counts the clock in `activity_clocks`, or as refreshing if a
/// refresh word is sent in it.
void Controller::count_waiting_clock(std::uint64_t& activity_clocks) {
  if (!refreshed_) put({});
  ++(refreshed_ ? account_.refreshing : activity_clocks);
}

void Controller::request_frame() {
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

/// No action: the next command begins the next segment or ends the frame.
void Controller::begin(const isa::SegmentEnd& /*end*/) {}

void Controller::begin(const isa::FrameEnd& end) {
  colour_ = end.colour;
  drained_ = 0;
  status_.busy = false;
  state_ = figures_.two_buffers && colour_.width > 0 ? State::holding : State::draining;
}

void Controller::issue() {
  const array::BitStep step = next_step();
  put_step(acted_at_, step);
  ++instruction_clocks_;
  if (step.pixels.function == array::AluFunction::answer) {
    state_ = State::waiting;
  } else if (step.last) {
    accounts.nb_write({.cleared = false, .clocks = instruction_clocks_});
    state_ = State::ready;
  }
}

array::BitStep Controller::next_step() {
  const auto [place, step] = last_step_ ? *std::exchange(last_step_, std::nullopt) : issued();
  status_.bit = place.bit;
  status_.pass = place.pass;
  return step;
}

Controller::Issued Controller::issued() {
  const Place place{sequencer_.bit(), sequencer_.pass()};
  return {place, sequencer_.issue()};
}

void Controller::put_step(std::uint64_t edge, const array::BitStep& step) {
  resting_ = false;
  wires->put(edge, {.step = step.pixels, .steps = true, .last = step.last, .ordinal = status_.ordinal}, step.root);
}

/// If the next command has been received and no refresh word can be requested, nothing affects the controller until the
/// last step of the current instruction. It then puts all steps before the last on the wires and sleeps.
void Controller::issue_ahead() {
  if (!receiver_.holds() || edges_to_drop_ > 0 || unlatched_) return;
  if (refreshes.num_available() > 0) return;
  ahead_.push_back({status_.bit, status_.pass});
  Issued next = issued();
  for (; !next.step.last; next = issued()) {
    put_step(acted_at_ + ahead_.size(), next.step);
    ahead_.push_back(next.place);
  }
  last_step_ = next;
  const std::uint64_t ahead = ahead_.size() - 1;
  account_.issuing += ahead;
  status_.clocks += ahead;
  instruction_clocks_ += ahead;
  if (ahead > 0) next_trigger(sc_core::sc_time::from_value((ahead + 1) * period_.value()));
}

/// Clears the region, except the bits of a displayed picture.
void Controller::clear() {
  const std::uint32_t clocks = std::max(figures_.clear_clocks, 1U);
  const std::uint32_t end = unlatched_ ? shown_.base : figures_.memory_bits;
  const ClearStep step = clear_step(region_, figures_.memory_bits, cleared_, clocks, end);
  ++cleared_;
  const bool last = cleared_ == clocks;
  put({.clears = true, .clear = step, .last = last, .ordinal = next_ordinal_});
  if (!last) return;
  accounts.nb_write({.cleared = true});
  state_ = State::ready;
}

/// Begins the copy with enable_all and copy, so that every pixel of the picture takes part.
void Controller::begin_copy() {
  state_ = State::copying;
  shown_ = {static_cast<std::uint16_t>(figures_.memory_bits - colour_.width), colour_.width};
  sequencer_.begin({.opcode = isa::Opcode::enable_all});
}

void Controller::copy() {
  const array::BitStep step = sequencer_.issue();
  put({.step = step.pixels, .ordinal = next_ordinal_});
  if (!step.last) return;
  if (sequencer_.instruction().opcode == isa::Opcode::copy) {
    state_ = State::draining;
  } else {
    sequencer_.begin({.opcode = isa::Opcode::copy, .fields = {shown_, colour_}});
  }
}

/// Ends the frame after its last step has been executed.
void Controller::finish() {
  if (!refreshed_) put({});
  state_ = State::idle;
  programs.write(++programs_done_);
  if (colour_.width == 0) return;
  if (!figures_.two_buffers) shown_ = colour_;
  unlatched_ = true;
  pictures.nb_write({shown_});
}

void Controller::put(const ControlWord& word, const array::RootBits& bits) {
  if (resting_ && word == ControlWord{}) return;
  resting_ = word == ControlWord{};
  wires->put(acted_at_, word, bits);
}

void Controller::take_answer() {
  if (!answer.read().valid) return;
  const isa::Instruction& question = status_.instruction;
  const bool any_enabled = answer.read().any_enabled;
  const std::uint64_t skipped = isa::skipped_instruction_count(question, any_enabled ? 1 : 0);
  accounts.nb_write({.cleared = false,
                     .clocks = instruction_clocks_,
                     .answered = question.opcode == isa::Opcode::global_or,
                     .answer = any_enabled,
                     .skipped = skipped});
  state_ = State::ready;
  if (skipped > 0) skip_instructions(skipped);
}

void Controller::skip_instructions(std::uint64_t instruction_count) {
  next_ordinal_ += instruction_count;
  requests.nb_write(next_ordinal_);
  receiver_.drop(link);
  edges_to_drop_ = 2;
  jumped_ = true;
}

void Controller::receive() {
  if (edges_to_drop_ == 0) return receiver_.clock(link);
  --edges_to_drop_;
  receiver_.drop(link);
}

}  // namespace csgsim::pixel_planes
