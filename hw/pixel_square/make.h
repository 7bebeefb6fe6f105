#pragma once

#include <cstddef>
#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"

namespace csgsim::pixel_square {

/// For a description of this kind of machine.
std::unique_ptr<systemc::ClockedMachine> make_machine(const machines::Machine& machine);

/// With trees that are stepped, in every renderer.
std::unique_ptr<systemc::ClockedMachine> make_stepped_machine(const machines::Machine& machine);

/// None: the whole machine is built for a wave.
inline constexpr std::nullptr_t make_probed_machine = nullptr;

}  // namespace csgsim::pixel_square
