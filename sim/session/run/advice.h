// Measures changed parameters and settings that could speed a run up.
// Used by sim/session, sim/shell and sim/viewer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hw/machines/machine.h"
#include "sim/engine/engine.h"
#include "sim/observe/knobs.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"

namespace csgsim::session {

/// Request for changes that speed a run up.
struct Advice {
  std::string machine;    ///< value of --machine; empty for no advice
  bool is_asked = false;  ///< --advice; otherwise nothing is tried, since it takes as long as many runs
  std::string ask;        ///< hint that names the option for advice
  /// Recompiles with other settings to measure their worth; empty if there is no model.
  std::function<std::vector<observe::Knob>(const engine::RunResult&)> settings{};
  std::vector<std::string> commands{};  ///< hints about commands that measure what is not tried
};

/// The tried changes that help, best first; empty if advice was not requested.
std::vector<observe::Knob> measure_parameter_knobs(const Advice& advice, const isa::Program& program,
                                                   const machines::Machine& machine, const engine::RunResult& result);

/// The worth of options of csgsim render, each changed by one step, and of the selection of prunings that helps most.
/// Each variant is compiled, and also simulated if its run may skip instructions.
std::vector<observe::Knob> measure_setting_knobs(const CompiledModel& model, const ModelRequest& request,
                                                 const machines::Machine& machine, const engine::RunResult& result);

}  // namespace csgsim::session
