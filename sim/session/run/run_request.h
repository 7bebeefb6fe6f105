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

inline constexpr unsigned most_threads = 1024;

/// Options of every command that runs a Program to a picture.
struct RunRequest {
  std::string picture;
  std::string depth;
  std::string owner;
  std::string surface = "nearest";  ///< of which depth and owner are: `nearest`, or what is `opaque` behind it
  std::string stats;
  ReportOption report;  ///< only commands that have a model add it
  std::string level = "functional";
  std::string evaluator = "worked-out";  ///< of the cycle level: one of evaluator_names
  std::string progress = "auto";
  unsigned threads = 1;
  bool advice = false;  ///< try all that could be turned, to see what it is worth

  void add_to(OptionList& options);

  /// Of these only what is written.
  void add_outputs_to(OptionList& options);
};

/// The names of the levels of fidelity.
std::vector<std::string> level_names();

/// The names of the forms that multiplier trees are built in.
std::vector<std::string> evaluator_names();

/// Throws UsageError for one that is no form at that level.
systemc::EvaluatorForm evaluator_form(const std::string& evaluator, const std::string& level = "cycle");

/// Of a run that may take long: what to say of it.
observe::LongWork long_run(const std::string& level);

/// An engine of the level of that name.
std::unique_ptr<engine::Engine> make_engine(const machines::Machine& machine, const std::string& level,
                                            unsigned threads,
                                            systemc::EvaluatorForm form = systemc::EvaluatorForm::worked_out);

/// A Program drawn without files.
struct Drawn {
  observe::Frame frame;  ///< as the machine shows it
  observe::Stats stats;
  engine::RunResult result;
  double seconds = 0;  ///< wall time
};

/// Runs it at that level, and tells how far it is. Throws InputError where memory does not hold it, or as
/// refuse_overflow does.
Drawn draw(const isa::Program& program, const machines::Machine& machine, const std::string& level = "functional",
           bool shows_progress = false);

/// Says how right a finished picture is: writes it for the stats, and returns lines of text for the summary.
using Judge = std::function<std::string(const observe::Frame&, nlohmann::ordered_json&)>;

/// Throws InputError if a linear expression did not fit its width somewhere.
void refuse_overflow(const engine::RunResult& result);

}  // namespace csgsim::session
