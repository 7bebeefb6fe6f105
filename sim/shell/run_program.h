#pragma once

#include "sim/session/run/finished_run.h"

namespace csgsim::shell {

using namespace session;

/// Runs the Program at the level asked for, writes what was asked for and prints the summary. Where there is a judge,
/// its verdict goes into the stats under `accuracy`; what the run follows from is under `configuration`. `advice`
/// says what may be tried to better it.
void run_program(const OptionList& asked, const RunSubject& subject, const RunRequest& request, RunOutputs& outputs,
                 const Advice& advice, const Judge& judge = {}, const CheckpointOptions& checkpoints = {});

}  // namespace csgsim::shell
