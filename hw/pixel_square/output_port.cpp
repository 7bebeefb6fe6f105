#include "hw/pixel_square/output_port.h"

namespace csgsim::pixel_square {

OutputPort::OutputPort(sc_core::sc_module_name name, const Figures& figures)
    : sc_core::sc_module(name),
      latch_bits_(figures.buffers >= 2 ? no_latch : figures.latch_bits),
      buffer_(colour_word_bits(figures)) {
  SC_HAS_PROCESS(OutputPort);
  SC_METHOD(act);
  dont_initialize();
  sensitive << clock.pos() << begun;
}

/// Sleeps while it has nothing to send.
void OutputPort::act() {
  if (begun.event()) begin_square();
  if (clock.posedge()) {
    transfer();
    send();
    latch();
  }
  if (!buffer_.busy()) next_trigger(begun.value_changed_event());
}

void OutputPort::begin_square() {
  const isa::Region region = region_of(header.read());
  if (latch_bits_ == no_latch || colour_.width == 0) return buffer_.load(*memory[0], colour_, region);
  buffer_.begin(region, colour_.width);
  latched_ = 0;
  rows_to_latch_ = region.height;
}

void OutputPort::transfer() {
  if (!buffer_.wants_row() || latched_ < colour_.width) return;
  buffer_.take_row(*memory[0], colour_);
  latched_ = 0;
  --rows_to_latch_;
}

void OutputPort::latch() {
  if (rows_to_latch_ > 0 && latched_ < colour_.width) latched_ += latch_bits_;
}

void OutputPort::send() {
  if (moving.read() || !buffer_.busy() || !buffer_.has_word() || colours.num_free() == 0) return;
  colours.nb_write(buffer_.word());
  buffer_.advance();
  if (!buffer_.busy()) left.write(++left_count_);
}

}  // namespace csgsim::pixel_square
