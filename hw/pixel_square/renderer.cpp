#include "hw/pixel_square/renderer.h"

#include <utility>

namespace csgsim::pixel_square {

using machines::SquareActivity;

namespace {

array::PlaneShape plane_shape(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

}  // namespace

Renderer::Renderer(sc_core::sc_module_name name, const machines::Machine& machine)
    : sc_core::sc_module(name),
      buffered_(machine.pixel_square.buffers >= 2),
      sequencer_(machine.memory_reads, machine.alu_bits),
      trees_(plane_shape(machine)),
      leaves_(plane_shape(machine).padded_words()),
      pixels_(machine.array, machine.alu_bits),
      output_(machine.pixel_square.port_bits),
      delay_(trees_.levels()) {
  SC_HAS_PROCESS(Renderer);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

void Renderer::begin(isa::Field colour) {
  colour_ = colour;
  squares_ = 0;
  idle_ = 0;
  counter_.clear();
}

machines::SquareClocks Renderer::account() const {
  machines::SquareClocks clocks = counter_.clocks();
  clocks[static_cast<std::size_t>(SquareActivity::done)] += idle_;
  return clocks;
}

void Renderer::on_clock() {
  const bool output_free = !output_.busy();
  send();
  const SquareActivity activity = draw(output_free);
  if (!in_square_ && activity == SquareActivity::waiting_for_divider) {
    ++idle_;
    return;
  }
  for (; idle_ > 0; --idle_) counter_.count(SquareActivity::waiting_for_divider);
  counter_.count(activity);
}

void Renderer::send() {
  if (output_.busy() && colours.num_free() > 0) {
    colours.nb_write(output_.word());
    output_.advance();
  }
}

SquareActivity Renderer::draw(bool output_free) {
  switch (state_) {
    case State::drawing:
    case State::draining: return issue(output_free);
    case State::drawn:
      if (output_free) move_out();
      return SquareActivity::waiting_for_frame_buffer;
    case State::moving:
      if (!output_.busy()) finish();
      return SquareActivity::waiting_for_frame_buffer;
  }
  return SquareActivity::working;
}

/// Puts the next step on its way, or none if there is no instruction, and lets the pixels obey the one that arrives.
SquareActivity Renderer::issue(bool output_free) {
  ControlWord word;
  const bool draining = state_ == State::draining;
  const bool waiting = !draining && !sequencer_.busy() && !fetch(word);
  if (waiting && !in_square_) return SquareActivity::waiting_for_divider;
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

/// Takes an instruction, or the end of the square, which goes into the control word.
bool Renderer::fetch(ControlWord& word) {
  InstructionWord taken;
  if (!link.nb_read(taken)) return false;
  if (!in_square_) begin_square(taken.square);
  if (taken.instruction != nullptr) {
    sequencer_.begin(*taken.instruction);
  } else {
    word.end = true;
    state_ = State::draining;
  }
  return true;
}

void Renderer::begin_square(const Square& square) {
  in_square_ = true;
  square_ = square;
  retired_ = 0;
  enabled_ = 0;
  pixels_.reset(square.region.width, square.region.height);
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
  retirement->drawn(square_.segment, pixels_);
  state_ = State::drawn;
  if (output_free) move_out();
}

void Renderer::retire() {
  retirement->carried_out(
      {.segment = square_.segment, .index = retired_++, .clocks = issued_.front(), .enabled_pixels = enabled_},
      pixels_);
  issued_.pop_front();
  enabled_ = pixels_.count_enabled();
}

void Renderer::move_out() {
  output_.load(pixels_, colour_, square_.region);
  state_ = State::moving;
  if (buffered_) finish();
}

void Renderer::finish() {
  state_ = State::drawing;
  in_square_ = false;
  ++squares_;
  finished.write(++finished_count_);
}

}  // namespace csgsim::pixel_square
