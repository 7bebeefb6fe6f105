#pragma once

#include <functional>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/systemc/evaluator_form.h"

namespace csgsim::test {

/// Whether a random Program is drawn; others are passed over.
using Allowed = std::function<bool(const isa::Program&)>;

inline bool all_allowed(const isa::Program& /*program*/) { return true; }

// Properties, one a kind: random Programs, of at most so many instructions a segment, or random models, on the clocked
// machine leave the bits and the picture of the reference, and take the clocks, the account and the timeline that are
// worked out. One machine a process, as SystemC elaborates once.
bool agree_planes(const machines::Machine& machine, unsigned instructions, systemc::EvaluatorForm evaluator,
                  const Allowed& allowed = all_allowed);
bool agree_planes_in_sequences(const machines::Machine& machine, unsigned instructions,
                               systemc::EvaluatorForm evaluator, const Allowed& allowed = all_allowed);
bool agree_scan_line(const machines::Machine& machine, unsigned instructions, const Allowed& allowed = all_allowed);
bool agree_scan_line_in_sequences(const machines::Machine& machine, unsigned instructions,
                                  const Allowed& allowed = all_allowed);
bool agree_squares(const machines::Machine& machine, unsigned instructions, systemc::EvaluatorForm evaluator,
                   const Allowed& allowed = all_allowed);
bool agree_nodes(const machines::Machine& machine, const Allowed& allowed = all_allowed);
bool agree_memory(const machines::Machine& machine, unsigned instructions, const Allowed& allowed = all_allowed);

/// Inside a property: the first of these Programs that is allowed; none of many is no case.
isa::Program first_allowed(const std::function<isa::Program()>& any_program, const Allowed& allowed);

}  // namespace csgsim::test
