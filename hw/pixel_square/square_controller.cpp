#include "hw/pixel_square/square_controller.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "hw/base/quotient.h"
#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_planes/clear_step.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/port_word.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

using pixel_planes::ControlWord;

SquareController::SquareController(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      period_(systemc::period_of(machine)),
      figures_(machines::kind_figures<Figures>(machine)),
      clear_clocks_(std::max(machine.clear_clocks, 1U)),
      memory_bits_(machine.array.memory_bits),
      latency_(machines::evaluator_latency(machine)),
      pixels_(std::uint64_t{machine.array.width} * machine.array.height),
      receiver_(command_word_bits(machines::kind_figures<Figures>(machine), machine.link.width)),
      sequencer_(machine.memory_reads, machine.alu_bits, machine.evaluator_bits) {
  SC_HAS_PROCESS(SquareController);
  SC_METHOD(act);
  dont_initialize();
  sensitive << clock.pos() << left;
}

void SquareController::end_of_elaboration() {
  left_or_word_ |= left.value_changed_event();
  left_or_word_ |= link.data_written_event();
}

void SquareController::begin(std::uint32_t colour_bits) {
  waiting_ = waiting_square_capacity(figures_, colour_bits);
  if (figures_.backing_bits == no_backing) {
    move_clocks_ = figures_.move_bits == all_planes ? 0 : quotient_up(colour_bits, figures_.move_bits);
  } else {
    const std::uint64_t bits = pixels_ * colour_bits;
    move_clocks_ = figures_.backing_width == all_planes ? 0 : quotient_up(bits, std::uint64_t{figures_.backing_width});
  }
  squares_ = 0;
  idle_from_ = edges();
  clocks_ = {};
}

std::string_view SquareController::state() const {
  constexpr auto names = std::to_array<std::string_view>(
      {"idle", "clearing", "drawing", "asking", "draining", "drawn", "moving", "leaving"});
  return names.at(static_cast<std::size_t>(state_));
}

/// Clock edges since the machine was built.
std::uint64_t SquareController::edges() const { return systemc::edges(period_); }

/// Runs at a clock edge, and when the last word of a square leaves at an edge, because this frees the pixels if there
/// is no second buffer. While idle, sleeps until a word arrives.
void SquareController::act() {
  const bool was_idle = state_ == State::idle;
  if (clock.posedge()) {
    advance(count());
  } else if (state_ == State::leaving && left.event()) {
    count();
    finish();
  } else {
    return;
  }
  put_control_word();
  if (was_idle && state_ != State::idle) clocks_.add(SquareActivity::waiting_for_divider, edges() - idle_from_);
  if (state_ == State::idle && !was_idle) idle_from_ = edges();
  sleep();
}

/// Accounts for the elapsed clocks and returns their number.
std::uint64_t SquareController::count() {
  const std::uint64_t now = edges();
  const std::uint64_t clocks = now - std::exchange(acted_at_, now);
  put_at_ = now;
  if (state_ != State::idle) clocks_.add(activity_, clocks);
  return clocks;
}

void SquareController::advance(std::uint64_t clocks) {
  receiver_.clock(link);
  if (state_ == State::asking) take_answer();
  if (state_ == State::draining && (clocks_left_ -= clocks) == 0) state_ = State::drawn;
  if (state_ == State::moving && (clocks_left_ -= clocks) == 0) finish();
  if (state_ == State::drawn && begun_count_ - left.read() < std::max<std::uint64_t>(waiting_, 1)) begin_output();
}

void SquareController::take_answer() {
  if (!answer.read().valid) return;
  skips_left_ = isa::skipped_instruction_count(sequencer_.instruction(), answer.read().any_enabled ? 1 : 0);
  accounts.nb_write({.kind = CommandAccount::Kind::instruction, .clocks = instruction_clocks_, .skipped = skips_left_});
  state_ = State::drawing;
}

void SquareController::begin_output() {
  header.write(header_of(region_));
  begun.write(++begun_count_);
  if (waiting_ == 0) {
    state_ = State::leaving;
    return;
  }
  state_ = State::moving;
  clocks_left_ = move_clocks_;
  moving.write(clocks_left_ > 0);
  if (clocks_left_ == 0) finish();
}

void SquareController::finish() {
  state_ = State::idle;
  moving.write(false);
  ++squares_;
  finished.write(++finished_count_);
}

/// Issues the control word of the clock that begins now.
void SquareController::put_control_word() {
  if ((state_ == State::idle || state_ == State::drawing) && !is_issuing()) take_command();
  switch (state_) {
    case State::idle: activity_ = SquareActivity::waiting_for_divider; return put_idle_word();
    case State::clearing: activity_ = SquareActivity::working; return clear();
    case State::drawing:
      activity_ = is_issuing() ? SquareActivity::working : SquareActivity::waiting_for_divider;
      return is_issuing() ? issue() : put_idle_word();
    case State::asking:
      activity_ = SquareActivity::working;
      ++instruction_clocks_;
      return put_idle_word();
    case State::draining: activity_ = SquareActivity::working; return drain();
    case State::moving: activity_ = SquareActivity::working; return put_idle_word();
    case State::drawn:
    case State::leaving: activity_ = SquareActivity::waiting_for_frame_buffer; return put_idle_word();
  }
}

void SquareController::take_command() {
  if (!receiver_.holds()) return;
  const isa::Command command = receiver_.take();
  if (skips_left_ > 0) {
    --skips_left_;
    ++ordinal_;
    return;
  }
  if (const auto* start = std::get_if<isa::SegmentStart>(&command)) {
    begin_square(start->region);
  } else if (const auto* instruction = std::get_if<isa::Instruction>(&command)) {
    sequencer_.begin(*instruction);
    instruction_clocks_ = 0;
  } else {
    state_ = State::draining;
    clocks_left_ = latency_ + 1;
  }
}

void SquareController::begin_square(const isa::Region& region) {
  region_ = region;
  ordinal_ = 0;
  state_ = State::clearing;
  clocks_left_ = clear_clocks_;
}

void SquareController::clear() {
  const auto elapsed = static_cast<std::uint32_t>(clear_clocks_ - clocks_left_--);
  put({.clears = true,
       .clear = pixel_planes::clear_step(region_, memory_bits_, elapsed, clear_clocks_, memory_bits_),
       .last = clocks_left_ == 0});
  if (clocks_left_ > 0) return;
  accounts.nb_write({.kind = CommandAccount::Kind::start, .region = region_});
  state_ = State::drawing;
}

void SquareController::issue() {
  const array::BitStep step = last_step_ ? *std::exchange(last_step_, std::nullopt) : sequencer_.issue();
  put_step(step);
  if (!step.last) return;
  ++ordinal_;
  if (step.pixels.function == array::AluFunction::answer) {
    state_ = State::asking;
    return;
  }
  accounts.nb_write({.kind = CommandAccount::Kind::instruction, .clocks = instruction_clocks_});
}

/// A word without a step follows the last step.
void SquareController::drain() {
  if (clocks_left_ <= latency_) return put_idle_word();
  put({.last = true, .ordinal = ordinal_});
  accounts.nb_write({.kind = CommandAccount::Kind::end});
}

void SquareController::put_idle_word() {
  if (wires_idle_) return;
  put({});
  wires_idle_ = true;
}

/// Sleeps beyond the next edge if there is nothing to do at it. A word that arrives while there is room for it is
/// received at the next edge.
void SquareController::sleep() {
  const bool holds = receiver_.holds();
  if (!holds && link.num_available() > 0) return;
  switch (state_) {
    case State::asking: return;
    case State::idle: return next_trigger(link.data_written_event());
    case State::clearing:
      if (holds) sleep(clear_ahead());
      return;
    case State::drawing:
      if (holds && sequencer_.busy()) return sleep(issue_ahead());
      if (!holds && wires_idle_) next_trigger(link.data_written_event());
      return;
    case State::draining:
      if (wires_idle_) sleep(clocks_left_);
      return;
    case State::moving: return sleep(clocks_left_);
    case State::drawn:
    case State::leaving: return holds ? next_trigger(left.value_changed_event()) : next_trigger(left_or_word_);
  }
}

void SquareController::sleep(std::uint64_t clocks) {
  if (clocks < 2) return;
  const sc_core::sc_time time = sc_core::sc_time::from_value(clocks * period_.value());
  if (receiver_.holds()) return next_trigger(time);
  next_trigger(time, link.data_written_event());
}

/// Issues all remaining clearing words but the last. Returns the number of clocks until the last one is due.
std::uint64_t SquareController::clear_ahead() {
  while (clocks_left_ > 1) {
    ++put_at_;
    clear();
  }
  return put_at_ + 1 - acted_at_;
}

/// Issues all remaining steps but the last, which it keeps. Returns the number of clocks until the last one is due.
std::uint64_t SquareController::issue_ahead() {
  array::BitStep step = sequencer_.issue();
  for (; !step.last; step = sequencer_.issue()) {
    ++put_at_;
    put_step(step);
  }
  last_step_ = step;
  return put_at_ + 1 - acted_at_;
}

void SquareController::put(const ControlWord& word, const array::RootBits& bits) {
  wires->put(put_at_, word, bits);
  wires_idle_ = false;
}

void SquareController::put_step(const array::BitStep& step) {
  put({.step = step.pixels, .steps = true, .last = step.last, .ordinal = ordinal_}, step.root);
  ++instruction_clocks_;
}

}  // namespace csgsim::pixel_square
