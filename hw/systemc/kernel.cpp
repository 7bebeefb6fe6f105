#include "hw/systemc/kernel.h"

#include "hw/base/address_sanitizer.h"

#if CSGSIM_ADDRESS_SANITIZER
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#endif

/// Debian's libsystemc refers to the entry point of programs without their own main. It is never called.
int sc_main(int /*argc*/, char* /*argv*/[]) { return 0; }

namespace csgsim::systemc {

namespace {

void kill_threads(sc_core::sc_object& object) {
  sc_core::sc_process_handle process(&object);
  if (process.valid() && process.proc_kind() == sc_core::SC_THREAD_PROC_) process.kill();
  for (sc_core::sc_object* const child : object.get_child_objects()) kill_threads(*child);
}

void back_on_main_stack() {
#if CSGSIM_ADDRESS_SANITIZER
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

}  // namespace

sc_core::sc_time period_of(const machines::Machine& machine) {
  return {1.0 / static_cast<double>(machine.clock_hz), sc_core::SC_SEC};
}

/// Caches the last result: many modules call this function at the same time, and the division would dominate their
/// cost.
std::uint64_t edges(const sc_core::sc_time& period) {
  static std::uint64_t cached_at = 0;
  static std::uint64_t cached_period = 1;
  static std::uint64_t cached_edges = 0;
  const std::uint64_t now = sc_core::sc_time_stamp().value();
  if (now == cached_at && period.value() == cached_period) return cached_edges;
  cached_at = now;
  cached_period = period.value();
  cached_edges = now / cached_period;
  return cached_edges;
}

void stop() {
  for (sc_core::sc_object* const object : sc_core::sc_get_top_level_objects()) kill_threads(*object);
  sc_core::sc_stop();
}

bool is_stopped() { return sc_core::sc_get_status() == sc_core::SC_STOPPED; }

void elaborate() {
  if (sc_core::sc_get_status() != sc_core::SC_ELABORATION) return;
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  back_on_main_stack();
}

void run() {
  sc_core::sc_start();
  back_on_main_stack();
}

}  // namespace csgsim::systemc
