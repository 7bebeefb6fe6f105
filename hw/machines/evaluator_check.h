#pragma once

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// For kinds with multiplier trees: throws FigureError if the trees deliver more bits per clock than the ALU processes.
void check_evaluator(const Machine& machine);

}  // namespace csgsim::machines
