#pragma once

#include "hw/division/counts.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::pixel_square {

/// Throws InputError unless the segments of a Program with a display model are what a divider makes of that, so that
/// who watches a run can be told of them. For machines without a divider there is nothing to check.
void check_division(const isa::Program& program, const machines::Machine& machine);

/// Throws InputError, naming the figure, where what the divider has at hand for a surface of the square, or the
/// commands of the square, do not fit the machine.
void check_storage(const isa::Segment& square, const division::AtHand& at_hand, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
