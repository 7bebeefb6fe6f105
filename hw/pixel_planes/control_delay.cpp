#include "hw/pixel_planes/control_delay.h"

namespace csgsim::pixel_planes {

/// The output is a register too: the last of the `length`.
ControlDelay::ControlDelay(sc_core::sc_module_name name, unsigned length)
    : sc_core::sc_module(name), length_(length), registers_(length == 0 ? 0 : length - 1) {
  SC_HAS_PROCESS(ControlDelay);
  SC_METHOD(shift);
  dont_initialize();
  if (length == 0) {
    sensitive << in;
  } else {
    sensitive << clock.pos();
  }
}

/// Sleeps while words without a step follow each other in all registers.
void ControlDelay::shift() {
  const ControlWord& word = in.read();
  if (length_ == 0) return send(word);
  if (!clock.posedge()) return;
  if (registers_.empty()) {
    send(word);
  } else {
    send(registers_[oldest_]);
    registers_[oldest_] = word;
    oldest_ = oldest_ + 1 == registers_.size() ? 0 : oldest_ + 1;
  }
  empty_ = word == ControlWord{} ? empty_ + 1 : 0;
  if (empty_ >= length_) next_trigger(in.value_changed_event());
}

void ControlDelay::send(const ControlWord& word) {
  out.write(word);
  question.write(word.step.function == array::AluFunction::answer);
}

}  // namespace csgsim::pixel_planes
