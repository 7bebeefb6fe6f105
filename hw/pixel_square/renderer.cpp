#include "hw/pixel_square/renderer.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "hw/base/quotient.h"
#include "hw/pixel_square/figures.h"
#include "hw/systemc/array_view.h"

namespace csgsim::pixel_square {

namespace {

array::PlaneShape plane_shape(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

}  // namespace

Renderer::Renderer(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      buffered_(machines::own<Figures>(machine).buffers >= 2),
      clear_clocks_(machine.clear_clocks),
      move_bits_(machines::own<Figures>(machine).move_bits),
      receiver_(machine.link.width),
      sequencer_(machine.memory_reads, machine.alu_bits),
      trees_(plane_shape(machine)),
      leaves_(plane_shape(machine).padded_words()),
      pixels_(machine.array, machine.alu_bits),
      output_(machines::own<Figures>(machine).port_bits),
      delay_(trees_.levels()) {
  SC_HAS_PROCESS(Renderer);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

void Renderer::begin(isa::Field colour, const SquareNames& names) {
  colour_ = colour;
  names_ = &names;
  squares_ = 0;
  idle_ = 0;
  clocks_ = {};
}

SquareClocks Renderer::account() const {
  SquareClocks clocks = clocks_;
  clocks.add(SquareActivity::done, idle_);
  return clocks;
}

void Renderer::on_clock() {
  const bool output_free = !output_.busy();
  send();
  const SquareActivity activity = draw(output_free);
  receiver_.clock(link);
  if (state_ == State::idle && activity == SquareActivity::waiting_for_divider) {
    ++idle_;
    return;
  }
  clocks_.add(SquareActivity::waiting_for_divider, std::exchange(idle_, 0));
  clocks_.add(activity);
}

void Renderer::send() {
  const bool on_its_way = state_ == State::moving;
  if (on_its_way || !output_.busy() || colours.num_free() == 0) return;
  colours.nb_write(output_.word());
  output_.advance();
}

SquareActivity Renderer::draw(bool output_free) {
  switch (state_) {
    case State::idle:
    case State::drawing:
    case State::draining: return issue(output_free);
    case State::clearing: return clear();
    case State::drawn:
      if (output_free) move_out();
      return SquareActivity::waiting_for_frame_buffer;
    case State::moving:
      if (--clocks_left_ == 0) finish();
      return SquareActivity::working;
    case State::leaving:
      if (!output_.busy()) finish();
      return SquareActivity::waiting_for_frame_buffer;
  }
  return SquareActivity::working;
}

/// Puts the next step on its way, or none if there is no command, and lets the pixels obey the one that arrives.
SquareActivity Renderer::issue(bool output_free) {
  ControlWord word;
  const bool draining = state_ == State::draining;
  const bool waiting = !draining && !sequencer_.busy() && !fetch(word);
  if (state_ == State::clearing) return clear();
  if (waiting && state_ == State::idle) return SquareActivity::waiting_for_divider;
  array::RootBits root;
  if (sequencer_.busy()) {
    const array::BitStep step = sequencer_.issue();
    root = step.root;
    word = {.step = step.pixels, .last = step.last};
    ++instruction_clocks_;
    if (step.last) issued_.push_back(std::exchange(instruction_clocks_, 0));
  }
  step(root, word, output_free);
  return waiting ? SquareActivity::waiting_for_divider : SquareActivity::working;
}

/// Takes the receiver's command; the end of the square goes into the control word.
bool Renderer::fetch(ControlWord& word) {
  if (!receiver_.holds()) return false;
  const isa::Command command = receiver_.take();
  if (const auto* start = std::get_if<isa::SegmentStart>(&command)) {
    begin_square(*start);
  } else if (const auto* instruction = std::get_if<isa::Instruction>(&command)) {
    sequencer_.begin(*instruction);
  } else {
    word.end = true;
    state_ = State::draining;
  }
  return true;
}

void Renderer::begin_square(const isa::SegmentStart& start) {
  region_ = start.region;
  segment_ = names_->segment_of(region_);
  retired_ = 0;
  enabled_ = 0;
  pixels_.select(region_.width, region_.height);
  state_ = State::clearing;
  clocks_left_ = std::max(clear_clocks_, 1U);
}

/// Some bits of memory in each of the clocks, as evenly as they go.
SquareActivity Renderer::clear() {
  const std::uint64_t clocks = std::max(clear_clocks_, 1U);
  const std::uint64_t first = pixels_.memory_bits() * (clocks - clocks_left_) / clocks;
  const std::uint64_t end = pixels_.memory_bits() * (clocks - clocks_left_ + 1) / clocks;
  pixels_.clear_memory(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end - first));
  if (--clocks_left_ == 0) state_ = State::drawing;
  return SquareActivity::working;
}

/// Without a tree level the leaves are wires, which follow the roots within the clock.
void Renderer::step(const array::RootBits& root, const ControlWord& word, bool output_free) {
  if (delay_.empty()) {
    trees_.clock(root, leaves_);
    return obey(word, output_free);
  }
  const ControlWord arriving = std::exchange(delay_[oldest_], word);
  oldest_ = oldest_ + 1 == delay_.size() ? 0 : oldest_ + 1;
  obey(arriving, output_free);
  trees_.clock(root, leaves_);
}

void Renderer::obey(const ControlWord& word, bool output_free) {
  pixels_.step(word.step, leaves_);
  if (word.last) retire();
  if (!word.end) return;
  retirement->after_segment(segment_, kernel::ArrayView(pixels_));
  state_ = State::drawn;
  if (output_free) move_out();
}

void Renderer::retire() {
  retirement->after_instruction(
      {.segment = segment_, .index = retired_++, .clocks = issued_.front(), .enabled_pixels = enabled_},
      kernel::ArrayView(pixels_));
  issued_.pop_front();
  enabled_ = pixels_.count_enabled();
}

void Renderer::move_out() {
  output_.load(pixels_, colour_, region_);
  if (!buffered_) {
    state_ = State::leaving;
    return;
  }
  clocks_left_ = move_bits_ == all_planes ? 0 : quotient_up(colour_.width, move_bits_);
  state_ = State::moving;
  if (clocks_left_ == 0) finish();
}

void Renderer::finish() {
  state_ = State::idle;
  ++squares_;
  finished.write(++finished_count_);
}

}  // namespace csgsim::pixel_square
