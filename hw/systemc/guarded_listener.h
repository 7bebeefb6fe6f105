#pragma once

#include "hw/systemc/listener_guard.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::systemc {

/// A listener to which nothing more is told once it has thrown: the machine runs to its end without it.
class GuardedListener final : public RunListener {
 public:
  /// The listener has to live as long.
  explicit GuardedListener(RunListener& listener) : listener_(&listener) {}

  /// Throws what the listener threw, if it did.
  void rethrow() { guard_.rethrow(); }

  [[nodiscard]] Keep keeps_after(std::uint32_t segment, std::uint32_t index) override {
    Keep keep = Keep::nothing;
    guard_.run([&] { keep = listener_->keeps_after(segment, index); });
    return keep;
  }
  void after_instruction(const Retired& retired, const PixelView& pixels) override {
    guard_.run([&] { listener_->after_instruction(retired, pixels); });
  }
  void after_segment(std::uint32_t segment, const PixelView& pixels) override {
    guard_.run([&] { listener_->after_segment(segment, pixels); });
  }

 private:
  RunListener* listener_;
  ListenerGuard guard_;
};

}  // namespace csgsim::systemc
