// Runs a Program and writes its outputs.
// Used by sim/session and sim/shell.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/knobs.h"
#include "sim/observe/stats.h"
#include "sim/observe/stats_json.h"
#include "sim/session/run/advice.h"
#include "sim/session/run/checkpoint_options.h"
#include "sim/session/run/configuration.h"
#include "sim/session/run/run_outputs.h"
#include "sim/session/run/run_request.h"

namespace csgsim::session {

/// A completed run and its results.
struct FinishedRun {
  observe::Frame picture;  ///< the picture that the machine displays
  engine::RunResult result;
  observe::Stats stats;
  std::vector<observe::Knob> knobs;   ///< tried changes that help
  std::string_view level;             ///< level of the run
  double seconds = 0;                 ///< wall time
  nlohmann::ordered_json stats_file;  ///< content of the --stats file
  std::string verdict;                ///< lines of the judge for the summary

  /// Report on the run; `subject` is the Program and the machine that were run.
  [[nodiscard]] observe::Report report(const RunSubject& subject) const {
    return {subject.program, subject.machine, level, result, stats, seconds, knobs};
  }
};

/// Runs the Program at the requested level and writes the requested files. A judge's verdict goes into the stats under
/// `accuracy`. With `is_configured` the stats include the configuration even if they are not written.
FinishedRun finish_run(const OptionList& options, const RunSubject& subject, const RunRequest& request,
                       RunOutputs& outputs, const Advice& advice, const Judge& judge = {},
                       const CheckpointOptions& checkpoints = {}, bool is_configured = false);

}  // namespace csgsim::session
