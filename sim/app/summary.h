#pragma once

#include "sim/observe/stats_json.h"

namespace csgsim::app {

/// The readable summary of a run on standard output.
void print_summary(const sim::Report& report);

}  // namespace csgsim::app
