#include "hw/pixel_planes/pixel_processors.h"

namespace csgsim::pixel_planes {

PixelProcessors::PixelProcessors(sc_core::sc_module_name name, const isa::ArrayShape& shape, unsigned alu_bits)
    : sc_core::sc_module(name), pixels_(shape, alu_bits) {
  SC_HAS_PROCESS(PixelProcessors);
  refresh.bind(*this);
  enable_lines.bind(*this);
  SC_METHOD(step);
  dont_initialize();
  sensitive << clock.pos();
}

/// Sleeps while there is nothing to do.
void PixelProcessors::step() {
  if (!clock.posedge()) return;
  const ControlWord& word = control.read();
  if (word.clears) {
    pixels_.clear_memory(word.clear.address, word.clear.bits);
    pixels_.select(word.clear.width, word.clear.height);
  } else if (!word.refreshes) {
    pixels_.step(word.step, tree->current());
  }
  if (word.last) retired.write(++retired_count_);
  if (word == ControlWord{}) next_trigger(control.value_changed_event());
}

}  // namespace csgsim::pixel_planes
