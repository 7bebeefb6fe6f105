#pragma once

#include <functional>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/systemc/evaluator_form.h"

namespace csgsim::test {

/// Whether to draw a random Program; others are skipped.
using Allowed = std::function<bool(const isa::Program&)>;

inline bool all_allowed(const isa::Program& /*program*/) { return true; }

// Properties, one per kind of machine: random Programs of at most `instructions` per segment, or random models, leave
// the bits and the picture of the reference on the clocked machine and take the predicted clocks, account and timeline.
// One machine per process, as SystemC elaborates once.
bool agree_planes(const machines::Machine& machine, unsigned max_instructions, systemc::EvaluatorForm evaluator,
                  const Allowed& is_allowed = all_allowed);
bool agree_planes_in_sequences(const machines::Machine& machine, unsigned max_instructions,
                               systemc::EvaluatorForm evaluator, const Allowed& is_allowed = all_allowed);
bool agree_scan_line(const machines::Machine& machine, unsigned max_instructions,
                     const Allowed& is_allowed = all_allowed);
bool agree_scan_line_in_sequences(const machines::Machine& machine, unsigned max_instructions,
                                  const Allowed& is_allowed = all_allowed);
bool agree_squares(const machines::Machine& machine, unsigned max_instructions, systemc::EvaluatorForm evaluator,
                   const Allowed& is_allowed = all_allowed);
bool agree_nodes(const machines::Machine& machine, const Allowed& is_allowed = all_allowed);
bool agree_memory(const machines::Machine& machine, unsigned max_instructions, const Allowed& is_allowed = all_allowed);

/// The first of these Programs that is allowed, inside a property. The case is discarded if none is found.
isa::Program first_allowed(const std::function<isa::Program()>& any_program, const Allowed& allowed);

}  // namespace csgsim::test
