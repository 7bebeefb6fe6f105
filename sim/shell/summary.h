#pragma once

#include "sim/observe/stats_json.h"

namespace csgsim::shell {

/// The readable summary of a run on standard output.
void print_summary(const observe::Report& report);

}  // namespace csgsim::shell
