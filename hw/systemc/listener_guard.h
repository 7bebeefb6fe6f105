// Stores an exception until the run is complete.
// Used by GuardedListener and WaveRecorder.
#pragma once

#include <exception>
#include <utility>

namespace csgsim::systemc {

/// Keeps a listener's exception away from the SystemC kernel: the machine completes its run, and then the exception is
/// rethrown.
class ListenerGuard {
 public:
  /// Discards a stored exception.
  void begin() { thrown_ = nullptr; }

  /// Calls the listener, unless an earlier call has thrown.
  template <class Call>
  void run(const Call& call) {
    if (thrown_) return;
    try {
      call();
    } catch (...) {
      thrown_ = std::current_exception();
    }
  }

  /// Rethrows the listener's exception, if any.
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::exception_ptr thrown_;
};

}  // namespace csgsim::systemc
