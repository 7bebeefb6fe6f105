#pragma once

#include <span>
#include <vector>

#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// Draws the Programs one after the other on the clocked machine, each as soon as the one before it lets it: of each
/// but the last the interval is counted from its beginning to the next one's. Observer i sees Program i. Throws
/// InputError before it begins if the machine cannot run one of them.
std::vector<engine::RunResult> run_sequence(const machines::Machine& machine, std::span<const isa::Program> programs,
                                            std::span<engine::Observer* const> observers);

}  // namespace csgsim::cycle
