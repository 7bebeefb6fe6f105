#pragma once

#include <cstddef>
#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"

namespace csgsim::bit_serial_memory {

/// For a description of this kind of machine.
std::unique_ptr<systemc::ClockedMachine> make_machine(const machines::Machine& machine);

/// None: the whole machine is built for a wave.
inline constexpr std::nullptr_t make_probed_machine = nullptr;

}  // namespace csgsim::bit_serial_memory
