#pragma once

#include "hw/division/counts.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::pixel_square {

/// Throws InputError, naming the figure, where what the divider has at hand for a surface of the square, or the
/// commands of the square, do not fit the machine.
void check_storage(const isa::Segment& square, const division::AtHand& at_hand, const machines::Machine& machine);

/// Divides the Program's display model as the machine's divider does. Throws InputError where that makes other segments
/// than the Program's, or does not fit the divider. For machines without a divider there is nothing to check.
void check_division(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
