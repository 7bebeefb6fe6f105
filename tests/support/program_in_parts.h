#pragma once

#include <rapidcheck.h>

#include <cstddef>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::test {

/// Valid Programs for a machine that works on parts of the picture: a segment for each of machines::regions, of at most
/// so many instructions, none of which asks a question. Some segments, sometimes all, have no instruction; now and then
/// there is no colour field.
rc::Gen<isa::Program> arbitrary_program_in_parts(const machines::Machine& machine, std::size_t max_instructions);

}  // namespace csgsim::test
