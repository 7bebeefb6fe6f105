#include "hw/pixel_square/output_port.h"

namespace csgsim::pixel_square {

OutputPort::OutputPort(sc_core::sc_module_name name, std::uint32_t port_bits)
    : sc_core::sc_module(name), buffer_(port_bits) {
  SC_HAS_PROCESS(OutputPort);
  SC_METHOD(act);
  dont_initialize();
  sensitive << clock.pos() << begun;
}

/// Sleeps while it has nothing to send.
void OutputPort::act() {
  if (begun.event()) buffer_.load(*memory[0], colour_, region_of(header.read()));
  if (clock.posedge()) send();
  if (!buffer_.busy()) next_trigger(begun.value_changed_event());
}

void OutputPort::send() {
  if (moving.read() || !buffer_.busy() || colours.num_free() == 0) return;
  colours.nb_write(buffer_.word());
  buffer_.advance();
  if (!buffer_.busy()) left.write(++left_count_);
}

}  // namespace csgsim::pixel_square
