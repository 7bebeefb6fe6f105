// The cycle level: clocked SystemC machines as engines.
// Used by sim/session.
#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/evaluator_form.h"
#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// The only clocked machine of the process, built on the first call; make_cycle_engine, run_and_record and run_sequence
/// use it. Throws std::logic_error if another machine was built before, and InputError like
/// kinds::make_clocked_machine.
systemc::ClockedMachine& clocked_hardware(const machines::Machine& machine,
                                          systemc::EvaluatorForm form = systemc::EvaluatorForm::computed);

/// A cycle-level engine on existing hardware, which must outlive it. make_cycle_engine builds the hardware for the
/// kinds that come with csgsim.
std::unique_ptr<engine::Engine> make_clocked_engine(const machines::Machine& machine,
                                                    systemc::ClockedMachine& hardware);

}  // namespace csgsim::cycle
