#pragma once

#include <string>

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Of all figures of a machine's description, in whatever order and with whatever comments it is written.
std::string hash_of(const Machine& machine);

}  // namespace csgsim::machines
