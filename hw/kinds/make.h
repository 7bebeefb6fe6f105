#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"

namespace csgsim::kinds {

/// The SystemC model of the machine, of whatever kind it is. Throws std::logic_error for a kind that is not in the
/// table.
std::unique_ptr<kernel::ClockedMachine> make_clocked_machine(const machines::Machine& machine);

}  // namespace csgsim::kinds
