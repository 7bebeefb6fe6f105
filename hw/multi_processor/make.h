#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"

namespace csgsim::multi_processor {

/// For a description of this kind of machine.
std::unique_ptr<kernel::ClockedMachine> make_machine(const machines::Machine& machine);

}  // namespace csgsim::multi_processor
