#include "hw/pixel_square/renderer.h"

#include <optional>

#include "hw/array/stepped_evaluator.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

namespace {

array::PlaneShape plane_shape(const machines::Machine& machine) { return {machine.array.width, machine.array.height}; }

array::TreeForm tree_form(const machines::Machine& machine) {
  return {machine.evaluator_degree, machine.evaluator_bits, machine.register_levels};
}

std::optional<array::SteppedEvaluator> adders(const machines::Machine& machine, systemc::EvaluatorForm form) {
  if (form == systemc::EvaluatorForm::worked_out) return std::nullopt;
  return array::SteppedEvaluator(plane_shape(machine), tree_form(machine));
}

}  // namespace

/// The accounts are those of the commands that are on their way to the pixels, one a clock, and of the one before.
Renderer::Renderer(sc_core::sc_module_name name, const machines::Machine& machine, systemc::EvaluatorForm form)
    : sc_core::sc_module(name),
      trees_(tree_form(machine)),
      accounts_("accounts", static_cast<int>(machines::evaluator_latency(machine)) + 2),
      controller_("controller", machine),
      control_delay_("control_delay", machines::evaluator_latency(machine)),
      evaluator_("evaluator", plane_shape(machine), machine.register_levels, adders(machine, form)),
      processors_("processors", machine.array, machine.alu_bits),
      global_or_("global_or", plane_shape(machine), machines::own<Figures>(machine).or_fan_in),
      output_("output", machines::own<Figures>(machine)) {
  controller_.clock(clock);
  controller_.link(link);
  controller_.answer(answer_);
  controller_.left(left_);
  controller_.root(root_);
  controller_.control(control_);
  controller_.begun(begun_);
  controller_.header(header_);
  controller_.moving(moving_);
  controller_.finished(finished);
  controller_.accounts(accounts_);

  control_delay_.clock(clock);
  control_delay_.in(control_);
  control_delay_.out(control_at_pixels_);
  control_delay_.question(question_);

  evaluator_.clock(clock);
  evaluator_.root(root_);
  evaluator_.leaves(tree_bits_);

  processors_.clock(clock);
  processors_.control(control_at_pixels_);
  processors_.tree(tree_bits_);
  processors_.retired(retired_);

  global_or_.clock(clock);
  global_or_.question(question_);
  global_or_.enable(processors_.enable_lines);
  global_or_.answer(answer_);

  output_.clock(clock);
  output_.begun(begun_);
  output_.header(header_);
  output_.moving(moving_);
  output_.memory(processors_.refresh);
  output_.colours(colours);
  output_.left(left_);

  completion_.retired(retired_);
  completion_.accounts(accounts_);
  completion_.enable(processors_.enable_lines);
  completion_.retirement(retirement);
}

void Renderer::begin(isa::Field colour, const systemc::SegmentNames& names) {
  controller_.begin(colour.width);
  output_.begin(colour);
  completion_.begin(names);
}

}  // namespace csgsim::pixel_square
