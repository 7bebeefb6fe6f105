#include "hw/pixel_planes/control_delay.h"

namespace csgsim::pixel_planes {

/// The output is a register too: the last of the `length`.
ControlDelay::ControlDelay(sc_core::sc_module_name name, unsigned length)
    : sc_core::sc_module(name), registers_(length == 0 ? 0 : length - 1) {
  SC_HAS_PROCESS(ControlDelay);
  SC_METHOD(shift);
  dont_initialize();
  if (length == 0) {
    sensitive << in;
  } else {
    sensitive << clock.pos();
  }
}

void ControlDelay::shift() {
  if (registers_.empty()) return send(in.read());
  send(registers_[oldest_]);
  registers_[oldest_] = in.read();
  oldest_ = oldest_ + 1 == registers_.size() ? 0 : oldest_ + 1;
}

void ControlDelay::send(const ControlWord& word) {
  out.write(word);
  question.write(word.step.function == array::AluFunction::answer);
}

}  // namespace csgsim::pixel_planes
