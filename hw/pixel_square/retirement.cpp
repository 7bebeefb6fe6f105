#include "hw/pixel_square/retirement.h"

#include <utility>

namespace csgsim::pixel_square {

Retirement::Retirement(sc_core::sc_module_name name) : sc_core::sc_module(name) {}

void Retirement::begin(RunListener& listener) {
  listener_ = &listener;
  thrown_ = nullptr;
}

void Retirement::rethrow() {
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Retirement::carried_out(const Retired& retired, const array::PixelArray& pixels) {
  guarded([&] { listener_->after_instruction(retired, pixels); });
}

void Retirement::drawn(std::uint32_t segment, const array::PixelArray& pixels) {
  guarded([&] { listener_->after_square(segment, pixels); });
}

template <class Call>
void Retirement::guarded(Call call) {
  if (thrown_) return;
  try {
    call();
  } catch (...) {
    thrown_ = std::current_exception();
  }
}

}  // namespace csgsim::pixel_square
