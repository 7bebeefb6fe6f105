#include "hw/pixel_square/output_port.h"

namespace csgsim::pixel_square {

OutputPort::OutputPort(sc_core::sc_module_name name, const Figures& figures)
    : sc_core::sc_module(name),
      latch_bits_(figures.buffers >= 2 || figures.backing_bits != no_backing ? no_latch : figures.latch_bits),
      port_bits_(colour_word_bits(figures)) {
  SC_HAS_PROCESS(OutputPort);
  SC_METHOD(act);
  dont_initialize();
  sensitive << clock.pos() << begun;
}

/// Sleeps while there is nothing to send.
void OutputPort::act() {
  if (begun.event()) begin_square();
  if (clock.posedge()) {
    transfer();
    send();
    latch();
  }
  if (squares_.empty()) next_trigger(begun.value_changed_event());
}

void OutputPort::begin_square() {
  const isa::Region region = region_of(header.read());
  OutputBuffer& square = squares_.emplace_back(port_bits_);
  if (latch_bits_ == no_latch || colour_.width == 0) return square.load(*memory[0], colour_, region);
  square.begin(region, colour_.width);
  latched_ = 0;
  rows_to_latch_ = region.height;
}

void OutputPort::transfer() {
  if (squares_.empty() || !squares_.front().needs_row() || latched_ < colour_.width) return;
  squares_.front().load_row(*memory[0], colour_);
  latched_ = 0;
  --rows_to_latch_;
}

void OutputPort::latch() {
  if (rows_to_latch_ > 0 && latched_ < colour_.width) latched_ += latch_bits_;
}

/// Sends the next word; the last queued square may still be moving.
void OutputPort::send() {
  if (squares_.empty() || (moving.read() && squares_.size() == 1)) return;
  OutputBuffer& square = squares_.front();
  if (!square.has_word() || colours.num_free() == 0) return;
  colours.nb_write(square.word());
  square.advance();
  if (square.busy()) return;
  squares_.pop_front();
  left.write(++left_count_);
}

}  // namespace csgsim::pixel_square
