// Consistency check of evaluator parameters.
// Used by hw/pixel_planes and hw/pixel_square.
#pragma once

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Throws FigureError if the multiplier trees deliver more bits per clock than the ALU processes.
void check_evaluator(const Machine& machine);

}  // namespace csgsim::machines
