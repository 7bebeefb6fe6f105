#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::pixel_square {

/// Throws InputError unless the segments of a Program with a display model are what a divider makes of that, so that
/// who watches a run can be told of them. For machines without a divider there is nothing to check.
void check_division(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
