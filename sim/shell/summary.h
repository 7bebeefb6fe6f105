// Printed summary of a run.
// Used by run_program.cpp.
#pragma once

#include <string>
#include <string_view>

#include "sim/observe/frame.h"
#include "sim/observe/stats_json.h"
#include "sim/session/run/advice.h"

namespace csgsim::shell {

using namespace session;

/// Prints the summary of a run: the picture's file, the model, the machine, the times, the host, the memory, the
/// judge's verdict and advice; at most 12 lines. `is_verbose`: print_details follows.
void print_run_summary(const observe::Report& report, const std::string& picture, const Advice& advice,
                       std::string_view verdict, bool is_verbose);

/// Prints the counts of a run, its most expensive primitives, and all changes that help.
void print_details(const observe::Report& report, const observe::Frame& picture, const Advice& advice);

}  // namespace csgsim::shell
