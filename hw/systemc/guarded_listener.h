// A listener that is disconnected when it throws.
// Used by Retirement and hw/scan_line.
#pragma once

#include "hw/systemc/listener_guard.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::systemc {

/// Forwards calls to a listener until it throws. The machine then completes its run without the listener.
class GuardedListener final : public RunListener {
 public:
  /// The listener must outlive this object.
  explicit GuardedListener(RunListener& listener) : listener_(&listener) {}

  /// Rethrows the listener's exception, if any.
  void rethrow() { guard_.rethrow(); }

  [[nodiscard]] Keep required_after(std::uint32_t segment, std::uint32_t index) override {
    Keep keep = Keep::nothing;
    guard_.run([&] { keep = listener_->required_after(segment, index); });
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
