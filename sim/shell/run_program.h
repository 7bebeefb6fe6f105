// Runs a Program and prints its summary.
// Used by sim/app.
#pragma once

#include "sim/session/run/finished_run.h"

namespace csgsim::shell {

using namespace session;

/// Adds --verbose.
void add_verbose_option(OptionList& options, RunRequest& request);

/// Runs the Program at the requested level, writes the requested files and prints the summary. The verdict of a judge,
/// if there is one, goes into the stats under `accuracy`; all inputs of the run are under `configuration`. `advice`
/// describes changes that may speed the run up.
void run_program(const OptionList& options, const RunSubject& subject, const RunRequest& request, RunOutputs& outputs,
                 const Advice& advice, const Judge& judge = {}, const CheckpointOptions& checkpoints = {});

}  // namespace csgsim::shell
