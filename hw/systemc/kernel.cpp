#include "hw/systemc/kernel.h"

#if defined(__SANITIZE_ADDRESS__)
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#endif

/// Debian's libsystemc refers to the entry point of programs that leave main to it. These have a main of their own.
int sc_main(int /*argc*/, char* /*argv*/[]) { return 0; }

namespace csgsim::kernel {

sc_core::sc_time period_of(const machines::Machine& machine) {
  return {1.0 / static_cast<double>(machine.clock_hz), sc_core::SC_SEC};
}

void back_on_main_stack() {
#if defined(__SANITIZE_ADDRESS__)
  pthread_attr_t attributes;
  void* bottom = nullptr;
  std::size_t bytes = 0;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return;
  pthread_attr_getstack(&attributes, &bottom, &bytes);
  pthread_attr_destroy(&attributes);
  void* fake = nullptr;
  __sanitizer_start_switch_fiber(&fake, bottom, bytes);
  __sanitizer_finish_switch_fiber(fake, nullptr, nullptr);
#endif
}

}  // namespace csgsim::kernel
