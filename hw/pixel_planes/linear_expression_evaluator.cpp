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

void LinearExpressionEvaluator::step() {
  if (trees_.clock(root.read().bits, leaves->next())) leaves->pass();
}

}  // namespace csgsim::pixel_planes
