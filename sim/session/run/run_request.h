// Options of drawing a Program, and the engines for its levels.
// Used by sim/app, sim/studies, sim/suite, sim/viewer and sim/web.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/systemc/evaluator_form.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/long_work.h"
#include "sim/observe/stats.h"
#include "sim/session/options/option_list.h"
#include "sim/session/run/report_option.h"

namespace csgsim::session {

inline constexpr unsigned max_threads = 1024;

/// Options of every command that runs a Program and draws a picture.
struct RunRequest {
  std::string picture;
  std::string depth;
  std::string owner;
  std::string surface = "nearest";  ///< surface in depth and owner: `nearest`, or the `opaque` one behind it
  std::string stats;
  ReportOption report;  ///< added only by commands that have a model
  std::string level = "functional";
  std::string evaluator = "worked-out";  ///< one of evaluator_names; used at the cycle level
  std::string progress = "auto";
  unsigned threads = 1;
  bool advice = false;   ///< try changed parameters and settings to measure their worth
  bool verbose = false;  ///< print more than the first lines; added only by commands that print

  void add_to(OptionList& options);

  /// Adds only the options of output files.
  void add_outputs_to(OptionList& options);
};

/// Names of the levels of fidelity.
std::vector<std::string> level_names();

/// Names of the forms of multiplier trees.
std::vector<std::string> evaluator_names();

/// Throws UsageError if the level does not support that form.
systemc::EvaluatorForm evaluator_form(const std::string& evaluator, const std::string& level = "cycle");

/// Name of a long run and advice how to shorten it, for warnings.
observe::LongWork long_run_warning(const std::string& level);

/// An engine of the level with that name.
std::unique_ptr<engine::Engine> make_engine(const machines::Machine& machine, const std::string& level,
                                            unsigned threads,
                                            systemc::EvaluatorForm form = systemc::EvaluatorForm::computed);

/// A Program drawn in memory, without files.
struct DrawnRun {
  observe::Frame frame;  ///< the picture that the machine displays
  observe::Stats stats;
  engine::RunResult result;
  double seconds = 0;  ///< wall time
};

/// Runs the Program at that level, with progress if requested. Throws InputError if memory does not suffice, or as
/// refuse_overflow does.
DrawnRun draw(const isa::Program& program, const machines::Machine& machine, const std::string& level = "functional",
              bool shows_progress = false);

/// Judges the accuracy of a finished picture: writes the result to the stats and returns lines for the summary.
using Judge = std::function<std::string(const observe::Frame&, nlohmann::ordered_json&)>;

/// Throws InputError if a linear expression overflowed its width.
void refuse_overflow(const engine::RunResult& result);

}  // namespace csgsim::session
