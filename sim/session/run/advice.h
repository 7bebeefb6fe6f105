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

/// How a run is to be bettered.
struct Advice {
  std::string machine;    ///< as --machine has it; empty for no advice
  bool is_asked = false;  ///< --advice; else nothing is tried, since that takes as long as many runs
  std::string ask;        ///< how to ask for it, for people
  /// Compiles again with other settings, to see what they are worth; none where there is no model.
  std::function<std::vector<observe::Knob>(const engine::RunResult&)> settings{};
  std::vector<std::string> commands{};  ///< that tell what is not tried, for people
};

/// What was tried and helps, the best first; nothing where it was not asked for.
std::vector<observe::Knob> knobs_of(const Advice& advice, const isa::Program& program, const machines::Machine& machine,
                                    const engine::RunResult& result);

/// What options of csgsim render are worth, each changed by one step. Each is compiled, and, where the run may skip
/// something, drawn.
std::vector<observe::Knob> setting_knobs(const CompiledModel& model, const ModelRequest& request,
                                         const machines::Machine& machine, const engine::RunResult& result);

}  // namespace csgsim::session
