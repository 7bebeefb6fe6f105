#include "hw/pixel_square/retirement.h"

namespace csgsim::pixel_square {

Retirement::Retirement(sc_core::sc_module_name name) : sc_core::sc_module(name) {}

void Retirement::begin(RunListener& listener) {
  listener_ = &listener;
  guard_.begin();
}

void Retirement::carried_out(const Retired& retired, const array::PixelArray& pixels) {
  guard_.run([&] { listener_->after_instruction(retired, pixels); });
}

void Retirement::drawn(std::uint32_t segment, const array::PixelArray& pixels) {
  guard_.run([&] { listener_->after_square(segment, pixels); });
}

}  // namespace csgsim::pixel_square
