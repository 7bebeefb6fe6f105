// Guards the single SystemC elaboration of a process.
// Used by the cycle engine, sim/python and sim/waves.
#pragma once

#include <stdexcept>

#include "hw/machines/machine.h"

namespace csgsim::cycle {

/// Thrown when a process tries to clock a second machine.
class ElaborationError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws ElaborationError unless the machine is the first of the process, or the same hardware as that one: SystemC
/// elaborates only once per process.
void claim_elaboration(const machines::Machine& machine);

}  // namespace csgsim::cycle
