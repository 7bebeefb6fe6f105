#pragma once

#include <memory>

#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/evaluator_form.h"
#include "sim/engine/engine.h"

namespace csgsim::cycle {

/// The one machine of the process, built by the first who asks: that of make_cycle_engine, run_and_record and
/// run_sequence. Throws std::logic_error if it is another, and InputError as kinds::make_clocked_machine.
systemc::ClockedMachine& clocked_hardware(const machines::Machine& machine,
                                          systemc::EvaluatorForm form = systemc::EvaluatorForm::worked_out);

/// The cycle level of a machine whose hardware is at hand, which has to live as long as the engine. make_cycle_engine
/// builds the hardware of the kinds that come with csgsim itself.
std::unique_ptr<engine::Engine> make_clocked_engine(const machines::Machine& machine,
                                                    systemc::ClockedMachine& hardware);

}  // namespace csgsim::cycle
