#include "hw/systemc/retirement.h"

namespace csgsim::systemc {

Retirement::Retirement(sc_core::sc_module_name name) : sc_core::sc_module(name) {}

void Retirement::begin(RunListener& listener) { listener_.emplace(listener); }

Keep Retirement::required_after(std::uint32_t segment, std::uint32_t index) {
  return listener_->required_after(segment, index);
}

void Retirement::after_instruction(const Retired& retired, const PixelView& pixels) {
  listener_->after_instruction(retired, pixels);
}

void Retirement::after_segment(std::uint32_t segment, const PixelView& pixels) {
  listener_->after_segment(segment, pixels);
}

}  // namespace csgsim::systemc
