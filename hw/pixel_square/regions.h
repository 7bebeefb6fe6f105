#pragma once

#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::pixel_square {

/// The squares of the machine's picture, as large as a renderer's array, those at the right and bottom edges cut off
/// there, in the machine's order; where a divider takes groups of squares first, group after group.
std::vector<isa::Region> regions(const machines::Machine& machine);

}  // namespace csgsim::pixel_square
