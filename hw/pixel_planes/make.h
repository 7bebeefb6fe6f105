#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/systemc/foretold.h"

namespace csgsim::pixel_planes {

/// For a description of this kind of machine.
std::unique_ptr<systemc::ClockedMachine> make_machine(const machines::Machine& machine);

/// With trees that are stepped.
std::unique_ptr<systemc::ClockedMachine> make_stepped_machine(const machines::Machine& machine);

/// Of which the foretold pixels alone are built.
std::unique_ptr<systemc::ClockedMachine> make_probed_machine(const machines::Machine& machine,
                                                             const systemc::Foretold& foretold,
                                                             systemc::EvaluatorForm form);

}  // namespace csgsim::pixel_planes
