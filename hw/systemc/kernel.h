#pragma once

#include <systemc>

#include "hw/machines/machine.h"

/// What all machines in SystemC share.
namespace csgsim::kernel {

/// The machine's clock period. Its first rising edge is one period after the start, not at time 0.
sc_core::sc_time period_of(const machines::Machine& machine);

/// To be called after each sc_start that has run threads. They have stacks of their own, and SystemC tells
/// AddressSanitizer of them, but not where the main stack is when it comes back to it; an exception would then seem to
/// overflow it. Without that sanitizer it does nothing.
void back_on_main_stack();

}  // namespace csgsim::kernel
