#pragma once

#include <functional>
#include <string>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "tests/lockstep/timed_machine.h"

namespace csgsim::test {

/// Draws Programs on a clocked machine that works on parts of the picture, and compares them with the reference's bits,
/// the functional engine's picture, clocks and account. `check` runs after each Program, with the recorded edges.
bool parts_agree(const std::string& what, const machines::Machine& machine,
                 const std::function<isa::Program()>& any_program,
                 const std::function<void(const isa::Program&, const TimedMachine&)>& check,
                 systemc::EvaluatorForm evaluator = systemc::EvaluatorForm::computed);

}  // namespace csgsim::test
