#include "hw/systemc/kernel.h"

/// Debian's libsystemc refers to the entry point of programs that leave main to it. These have a main of their own.
int sc_main(int /*argc*/, char* /*argv*/[]) { return 0; }

namespace csgsim::kernel {

sc_core::sc_time period_of(const machines::Machine& machine) {
  return {1.0 / static_cast<double>(machine.clock_hz), sc_core::SC_SEC};
}

}  // namespace csgsim::kernel
