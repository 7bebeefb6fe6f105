#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::studies {

/// Stands for every figure that may be ideal.
inline constexpr std::string_view every_figure = "all";

/// What of a machine can be made ideal, one after the other, and all at once if there is more than one.
std::vector<std::string> ideal_choices(const machines::Machine& machine);

/// The machine with that choice made; "" leaves it as it is.
machines::Machine made_ideal(machines::Machine machine, std::string_view choice);

}  // namespace csgsim::studies
