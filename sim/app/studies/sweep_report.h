#pragma once

#include <span>

#include "sim/study/sweep.h"

namespace csgsim::app {

/// The rows of one model on standard output: every point, table 6.1 of the thesis, and what follows from them.
void print_sweep(std::span<const study::SweepRow> rows);

}  // namespace csgsim::app
