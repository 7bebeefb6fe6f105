// Makes the SystemC model of a machine.
// Used by sim/cycle and sim/waves.
#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/earlier_run.h"
#include "hw/systemc/evaluator_form.h"

namespace csgsim::kinds {

/// The SystemC model of a machine of any kind. Throws std::logic_error if the kind is not in the table, and InputError
/// if the machine's trees do not support the form.
std::unique_ptr<systemc::ClockedMachine> make_clocked_machine(
    const machines::Machine& machine, systemc::EvaluatorForm form = systemc::EvaluatorForm::computed);

/// Whether the machine's multiplier trees can be simulated adder by adder.
bool can_be_stepped(const machines::Machine& machine);

/// Whether the SystemC model can consist of some of the machine's pixels only.
bool can_be_probed(const machines::Machine& machine);

/// The SystemC model with only the pixels of `earlier`; requires can_be_probed().
std::unique_ptr<systemc::ClockedMachine> make_probed_machine(const machines::Machine& machine,
                                                             const systemc::EarlierRun& earlier,
                                                             systemc::EvaluatorForm form);

}  // namespace csgsim::kinds
