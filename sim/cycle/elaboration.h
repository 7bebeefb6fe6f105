#pragma once

#include "hw/machines/machine.h"

namespace csgsim::cycle {

/// Throws std::logic_error unless the machine is the first of the process or the same hardware as that one: SystemC
/// elaborates once a process.
void claim_elaboration(const machines::Machine& machine);

}  // namespace csgsim::cycle
