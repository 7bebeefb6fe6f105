#pragma once

#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// The regions of the machine's picture, in the order in which it draws them: the whole; each line, if interlaced the
/// even ones first; or squares as large as the array, those at the right and bottom edges cut off there.
std::vector<isa::Region> regions(const Machine& machine);

}  // namespace csgsim::machines
