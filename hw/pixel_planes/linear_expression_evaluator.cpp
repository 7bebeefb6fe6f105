#include "hw/pixel_planes/linear_expression_evaluator.h"

namespace csgsim::pixel_planes {

/// Without a level the leaves are wires, which follow the roots within the clock.
LinearExpressionEvaluator::LinearExpressionEvaluator(sc_core::sc_module_name name, array::PlaneShape shape)
    : sc_core::sc_module(name), trees_(shape) {
  SC_HAS_PROCESS(LinearExpressionEvaluator);
  SC_METHOD(step);
  dont_initialize();
  if (trees_.levels() == 0) {
    sensitive << root;
  } else {
    sensitive << clock.pos();
  }
}

/// Sleeps while no bit is on its way.
void LinearExpressionEvaluator::step() {
  if (trees_.levels() > 0 && !clock.posedge()) return;
  const array::RootBits& bits = root.read().bits;
  if (TreeWord word; trees_.clock(bits, word.bit)) leaves.write(word);
  if (!bits.token.active() && !trees_.any_active()) next_trigger(root.value_changed_event());
}

}  // namespace csgsim::pixel_planes
