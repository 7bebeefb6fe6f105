#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/systemc/foretold.h"

namespace csgsim::kinds {

/// The SystemC model of the machine, of whatever kind it is. Throws std::logic_error for a kind that is not in the
/// table, and InputError for one whose trees, if it has any, cannot be of that form.
std::unique_ptr<systemc::ClockedMachine> make_clocked_machine(
    const machines::Machine& machine, systemc::EvaluatorForm form = systemc::EvaluatorForm::worked_out);

/// Whether the trees of a machine of that kind can be stepped.
bool can_be_stepped(const machines::Machine& machine);

/// Whether some pixels of a machine of that kind can be built alone.
bool can_be_probed(const machines::Machine& machine);

/// The SystemC model of such a machine, of which the foretold pixels alone are built.
std::unique_ptr<systemc::ClockedMachine> make_probed_machine(const machines::Machine& machine,
                                                             const systemc::Foretold& foretold,
                                                             systemc::EvaluatorForm form);

}  // namespace csgsim::kinds
