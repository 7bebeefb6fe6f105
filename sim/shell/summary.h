// Printed summary of a run.
// Used by run_program.cpp.
#pragma once

#include "sim/observe/frame.h"
#include "sim/observe/stats_json.h"
#include "sim/session/run/advice.h"

namespace csgsim::shell {

using namespace session;

/// Prints the summary of a run to standard output.
void print_summary(const observe::Report& report);

/// Prints the unit that bounds the frame, the most expensive primitives, and the knobs.
void print_words(const observe::Report& report, const observe::Frame& picture, const Advice& advice);

}  // namespace csgsim::shell
