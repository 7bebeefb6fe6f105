// Draws a sequence of Programs on the clocked machine.
// Used by cycle_engine.cpp, sim/session and tests.
#pragma once

#include <span>
#include <vector>

#include "hw/systemc/evaluator_form.h"
#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// Draws the Programs one after the other on the clocked machine, each as soon as the previous one allows it. The
/// interval of each but the last is counted from its start to the start of the next. Observer i observes Program i.
/// Throws InputError before the start if the machine cannot run one of the Programs, or as clocked_hardware does.
std::vector<engine::RunResult> run_sequence(const machines::Machine& machine, std::span<const isa::Program> programs,
                                            std::span<engine::Observer* const> observers,
                                            systemc::EvaluatorForm form = systemc::EvaluatorForm::computed);

}  // namespace csgsim::cycle
