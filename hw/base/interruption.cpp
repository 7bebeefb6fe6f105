#include "hw/base/interruption.h"

#include <utility>

namespace csgsim {

namespace {

thread_local const Interruptible* innermost = nullptr;

}  // namespace

Interruptible::Interruptible(std::stop_token stop) noexcept
    : stop_(std::move(stop)), before_(std::exchange(innermost, this)) {}

Interruptible::~Interruptible() { innermost = before_; }

void throw_if_interrupted() {
  if (innermost != nullptr && innermost->stop_.stop_requested()) throw Interrupted();
}

std::stop_token thread_stop_token() { return innermost == nullptr ? std::stop_token() : innermost->stop_; }

}  // namespace csgsim
