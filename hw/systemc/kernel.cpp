#include "hw/systemc/kernel.h"

#include "hw/base/address_sanitizer.h"

#if CSGSIM_ADDRESS_SANITIZER
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#endif

/// Debian's libsystemc refers to the entry point of programs that leave main to it. These have a main of their own.
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

/// Many ask at one time, and there is one machine: a division is slow beside what they do.
std::uint64_t edges(const sc_core::sc_time& period) {
  static std::uint64_t asked_at = 0;
  static std::uint64_t of_period = 1;
  static std::uint64_t answer = 0;
  const std::uint64_t now = sc_core::sc_time_stamp().value();
  if (now == asked_at && period.value() == of_period) return answer;
  asked_at = now;
  of_period = period.value();
  answer = now / of_period;
  return answer;
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
