#pragma once

#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"

/// What all machines in SystemC share.
namespace csgsim::systemc {

/// The machine's clock period. Its first rising edge is one period after the start, not at time 0.
sc_core::sc_time period_of(const machines::Machine& machine);

/// Rising edges of a clock of that period since the simulation began.
std::uint64_t edges(const sc_core::sc_time& period);

/// Ends the simulation for good (sc_stop), from within a method of it. Threads that wait are unwound first: what they
/// hold would never be given back.
void stop();

/// Has the simulation been ended for good?
bool is_stopped();

/// To be called after each sc_start that has run threads. They have stacks of their own, and SystemC tells
/// AddressSanitizer of them, but not where the main stack is when it comes back to it; an exception would then seem to
/// overflow it. Without that sanitizer it does nothing.
void back_on_main_stack();

}  // namespace csgsim::systemc
