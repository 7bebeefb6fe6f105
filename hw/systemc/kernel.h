#pragma once

#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"

/// What all machines in SystemC share.
namespace csgsim::systemc {

/// The machine's clock period. Its first rising edge is one period after the start, not at time 0.
sc_core::sc_time period_of(const machines::Machine& machine);

/// The time as it is now; what sc_time_stamp() returns refers to one that goes on.
inline sc_core::sc_time now() { return sc_core::sc_time_stamp(); }

/// Rising edges of a clock of that period since the simulation began.
std::uint64_t edges(const sc_core::sc_time& period);

/// Elaborates what has been built, if that has not been done. The clock stays at 0.
void elaborate();

/// Goes on with the simulation until it is paused or ended. Threads in it have stacks of their own, and SystemC tells
/// AddressSanitizer of them, but not where the main stack is when it comes back to it; an exception would then seem to
/// overflow it, and the search for leaks read stacks that are gone. So nobody else calls sc_start.
void run();

/// Ends the simulation for good (sc_stop), from within a method of it. Threads that wait are unwound first: what they
/// hold would never be given back.
void stop();

/// Has the simulation been ended for good?
bool is_stopped();

}  // namespace csgsim::systemc
