// Machines with parameters made ideal.
// Used by csgsim compare --ideal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::studies {

/// Selects all parameters that can be made ideal.
inline constexpr std::string_view every_figure = "all";

/// The parameters that can be made ideal, one by one, and `all` if there are several.
std::vector<std::string> ideal_choices(const machines::Machine& machine);

/// The machine with the chosen parameters made ideal; "" leaves it unchanged.
machines::Machine with_ideal_parameters(machines::Machine machine, std::string_view choice);

}  // namespace csgsim::studies
