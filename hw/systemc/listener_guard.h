#pragma once

#include <exception>
#include <utility>

namespace csgsim::systemc {

/// Keeps what a listener throws from the kernel: the machine runs to its end without it, and then it is thrown again.
class ListenerGuard {
 public:
  /// Forgets what was thrown before.
  void begin() { thrown_ = nullptr; }

  /// Calls the listener, unless it has thrown.
  template <class Call>
  void run(const Call& call) {
    if (thrown_) return;
    try {
      call();
    } catch (...) {
      thrown_ = std::current_exception();
    }
  }

  /// Throws what the listener threw, if it did.
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::exception_ptr thrown_;
};

}  // namespace csgsim::systemc
