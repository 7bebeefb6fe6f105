#pragma once

#include "sim/studies/jobs.h"
#include "sim/studies/sweep/points.h"

namespace csgsim::studies {

/// Compiles the point, counts, and, if asked to, draws it at the functional level. The clocks are those of a run. A
/// model that does not fit is a row that says why.
SweepRow measure(const SweepPoint& point, const Job& job, bool is_drawn);

}  // namespace csgsim::studies
