#include "sim/cycle/elaboration.h"

namespace csgsim::cycle {

void claim_elaboration(const machines::Machine& machine) {
  static const machines::Machine elaborated = machine;
  if (machines::is_same_hardware(machine, elaborated)) return;
  throw ElaborationError("SystemC elaborates only once per process, which was done for " + elaborated.name +
                         "; simulate " + machine.name + " clock by clock in a separate process");
}

}  // namespace csgsim::cycle
