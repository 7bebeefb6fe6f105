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

/// A run that came to its end, and all that is told of it.
struct FinishedRun {
  observe::Frame picture;  ///< as the machine shows it
  engine::RunResult result;
  observe::Stats stats;
  std::vector<observe::Knob> knobs;   ///< what was tried and helps
  std::string_view level;             ///< that it ran at
  double seconds = 0;                 ///< wall time
  nlohmann::ordered_json stats_file;  ///< what --stats writes
  std::string verdict;                ///< of the judge, lines for the summary

  /// Of the Program that was run, on the machine that ran it.
  [[nodiscard]] observe::Report report(const RunSubject& subject) const {
    return {subject.program, subject.machine, level, result, stats, seconds, knobs};
  }
};

/// Runs the Program at the level asked for and writes what was asked for. Where there is a judge, its verdict goes into
/// the stats under `accuracy`. With `is_configured` the stats have the configuration, whether or not they are written.
FinishedRun finish_run(const OptionList& options, const RunSubject& subject, const RunRequest& request,
                       RunOutputs& outputs, const Advice& advice, const Judge& judge = {},
                       const CheckpointOptions& checkpoints = {}, bool is_configured = false);

}  // namespace csgsim::session
