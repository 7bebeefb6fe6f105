#include "hw/pixel_square/renderer.h"

#include "hw/machines/clocks.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

namespace {

array::PlaneShape plane_shape(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

array::TreeForm tree_form(const machines::Machine& machine) {
  return {machine.evaluator_degree, machine.evaluator_bits, machine.register_levels};
}

}  // namespace

/// The FIFO of accounts has room for the commands on their way to the pixels, one per clock, and for the previous
/// command.
Renderer::Renderer(sc_core::sc_module_name name, const machines::Machine& machine, systemc::EvaluatorForm form)
    : sc_core::sc_module(name),
      trees_(tree_form(machine)),
      accounts_("accounts", static_cast<int>(machines::evaluator_latency(machine)) + 2),
      controller_("controller", machine),
      pipeline_("pipeline", machine, form),
      global_or_("global_or", plane_shape(machine), machines::kind_figures<Figures>(machine).or_fan_in),
      output_("output", machines::kind_figures<Figures>(machine)) {
  controller_.clock(clock);
  controller_.link(link);
  controller_.answer(answer_);
  controller_.left(left_);
  controller_.wires(pipeline_);
  controller_.begun(begun_);
  controller_.header(header_);
  controller_.moving(moving_);
  controller_.finished(finished);
  controller_.accounts(accounts_);

  pipeline_.question(question_);
  pipeline_.retired(retired_);

  global_or_.clock(clock);
  global_or_.question(question_);
  global_or_.enable(pipeline_);
  global_or_.answer(answer_);

  output_.clock(clock);
  output_.begun(begun_);
  output_.header(header_);
  output_.moving(moving_);
  output_.memory(pipeline_);
  output_.colours(colours);
  output_.left(left_);

  completion_.retired(retired_);
  completion_.accounts(accounts_);
  completion_.enable(pipeline_);
  completion_.retirement(retirement);
}

void Renderer::begin(isa::Field colour, const systemc::SegmentNames& names) {
  controller_.begin(colour.width);
  output_.begin(colour);
  completion_.begin(names);
}

}  // namespace csgsim::pixel_square
