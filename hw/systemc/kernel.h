#pragma once

#include <systemc>

#include "hw/machines/machine.h"

/// What all machines in SystemC share.
namespace csgsim::kernel {

/// The machine's clock period. Its first rising edge is one period after the start, not at time 0.
sc_core::sc_time period_of(const machines::Machine& machine);

}  // namespace csgsim::kernel
