#pragma once

#include "sim/observe/stats_json.h"

namespace csgsim::shell {

/// Prints what the machine's kind tells of the frame: counts, shares, and where the clocks of each part went.
void print_account(const observe::Report& report);

}  // namespace csgsim::shell
