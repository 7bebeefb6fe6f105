#pragma once

#include <span>
#include <vector>

#include "hw/systemc/evaluator_form.h"
#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// Draws the Programs one after the other on the clocked machine, each as soon as the one before it lets it: of each
/// but the last the interval is counted from its beginning to the next one's. Observer i sees Program i. Throws
/// InputError before it begins if the machine cannot run one of them, or as clocked_hardware does.
std::vector<engine::RunResult> run_sequence(const machines::Machine& machine, std::span<const isa::Program> programs,
                                            std::span<engine::Observer* const> observers,
                                            systemc::EvaluatorForm form = systemc::EvaluatorForm::worked_out);

}  // namespace csgsim::cycle
