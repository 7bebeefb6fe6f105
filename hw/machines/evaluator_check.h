#pragma once

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// For kinds whose pixels are below multiplier trees: throws FigureError if these bring the ALU more bits in a clock
/// than it takes.
void check_evaluator(const Machine& machine);

}  // namespace csgsim::machines
