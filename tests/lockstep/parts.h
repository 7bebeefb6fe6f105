#pragma once

#include <string>

#include "hw/machines/machine.h"

namespace csgsim::test {

/// Draws random Programs, or random models if the machine divides these, on a clocked machine that works on parts of the picture, and holds them against the
/// reference's bits, the functional engine's picture, clocks and account. RC_PARAMS overrides the seed and the number
/// of Programs.
bool agree_in_parts(const std::string& what, const machines::Machine& machine, unsigned programs,
                    unsigned instructions);

}  // namespace csgsim::test
