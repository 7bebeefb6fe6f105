#pragma once

#include "sim/observe/stats_json.h"

namespace csgsim::app {

/// Prints where the clocks of a machine that works on parts of the picture went; nothing for one that holds the whole.
void print_account(const sim::Report& report);

}  // namespace csgsim::app
