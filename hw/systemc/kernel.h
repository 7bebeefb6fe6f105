// Control of the SystemC simulation.
// Used by all SystemC machines and sim/waves.
#pragma once

#include <cstdint>
#include <systemc>

#include "hw/machines/machine.h"

// Helpers shared by all SystemC machines.
namespace csgsim::systemc {

/// The machine's clock period. Its first rising edge is one period after the start, not at time 0.
sc_core::sc_time period_of(const machines::Machine& machine);

/// A copy of the current time; sc_time_stamp() returns a reference to the running time.
inline sc_core::sc_time now() { return sc_core::sc_time_stamp(); }

/// Number of rising edges of a clock with that period since the start of the simulation.
std::uint64_t edges(const sc_core::sc_time& period);

/// Elaborates the design, unless that has been done. The time stays at 0.
void elaborate();

/// Continues the simulation until it is paused or stopped. Must be used instead of sc_start: SystemC threads have their
/// own stacks, and SystemC reports switches to them to AddressSanitizer, but not the return to the main stack. Without
/// the correction here exceptions would look like stack overflows, and leak detection would read freed stacks.
void run();

/// Stops the simulation for good (sc_stop); called from a method of it. Waiting threads are unwound first, since their
/// objects would otherwise leak.
void stop();

/// Whether the simulation has been stopped for good.
bool is_stopped();

}  // namespace csgsim::systemc
