// Control of the SystemC simulation.
// Used by hw and sim/waves.
#pragma once

#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"

// Helpers shared by all SystemC machines.
namespace csgsim::systemc {

/// The clock period of a machine. Its first rising edge is one period after the start, not at time 0.
sc_core::sc_time period_of(const machines::Machine& machine);

/// A copy of the current time; sc_time_stamp() returns a reference that changes with time.
inline sc_core::sc_time now() { return sc_core::sc_time_stamp(); }

/// Number of rising edges of a clock with period `period` since the start of the simulation.
std::uint64_t edges(const sc_core::sc_time& period);

/// Elaborates the design, unless this has been done. The time stays at 0.
void elaborate();

/// Continues the simulation until it is paused or stopped. Use this function instead of sc_start: SystemC threads have
/// their own stacks, and SystemC reports switches to these to AddressSanitizer, but not the return to the main stack.
/// Without the correction in this function exceptions would look like stack overflows, and leak detection would read
/// freed stacks.
void run();

/// Stops the simulation permanently (sc_stop); called from an SC_METHOD. Waiting threads are unwound first, since their
/// objects would otherwise leak.
void stop();

/// Whether stop() has been called.
bool is_stopped();

}  // namespace csgsim::systemc
