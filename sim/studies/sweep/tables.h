#pragma once

#include <span>

#include "sim/studies/sweep/points.h"

namespace csgsim::studies {

/// The rows of one model on standard output: every point, table 6.1 of the thesis, and what follows from them.
void print_sweep(std::span<const SweepRow> rows);

}  // namespace csgsim::studies
