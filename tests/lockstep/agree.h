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
bool planes_agree(const machines::Machine& machine, unsigned max_instructions, systemc::EvaluatorForm evaluator,
                  const Allowed& is_allowed = all_allowed);
bool planes_agree_in_sequences(const machines::Machine& machine, unsigned max_instructions,
                               systemc::EvaluatorForm evaluator, const Allowed& is_allowed = all_allowed);
bool scan_line_agrees(const machines::Machine& machine, unsigned max_instructions,
                      const Allowed& is_allowed = all_allowed);
bool scan_line_agrees_in_sequences(const machines::Machine& machine, unsigned max_instructions,
                                   const Allowed& is_allowed = all_allowed);
bool squares_agree(const machines::Machine& machine, unsigned max_instructions, systemc::EvaluatorForm evaluator,
                   const Allowed& is_allowed = all_allowed);
bool nodes_agree(const machines::Machine& machine, const Allowed& is_allowed = all_allowed);
bool memory_agrees(const machines::Machine& machine, unsigned max_instructions,
                   const Allowed& is_allowed = all_allowed);

/// The first of these Programs that is allowed, inside a property. The case is discarded if none is found.
isa::Program first_allowed(const std::function<isa::Program()>& any_program, const Allowed& allowed);

}  // namespace csgsim::test
