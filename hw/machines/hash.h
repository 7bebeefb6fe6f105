// Hash of a machine's parameters.
// Used by sim/session and sim/studies.
#pragma once

#include <string>

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Hash of all parameters of a machine, independent of the order and comments of its description.
std::string hash_of(const Machine& machine);

}  // namespace csgsim::machines
