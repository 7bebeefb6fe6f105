#pragma once

#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// The regions of the machine's picture, in the order in which it draws them: the whole; each line, if interlaced the
/// even ones first; or squares as large as the array, those at the right and bottom edges cut off there.
std::vector<isa::Region> regions(const Machine& machine);

/// Throws InputError unless the Program can run on the machine, if that is of a kind that works on parts of the
/// picture: its segments are the regions of the machine, its memory is there, and it asks for no answer, which no wire
/// brings back.
void check_parts(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
