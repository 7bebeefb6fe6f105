#pragma once

#include <systemc>

#include "hw/array/linear_evaluator.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/plane_channel.h"

namespace csgsim::pixel_planes {

/// The two multiplier trees (thesis fig. 7.1): coefficient bits in at the roots, a bit of F out at every pixel.
class LinearExpressionEvaluator final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<RootWord> root{"root"};
  sc_core::sc_port<PlaneOut> leaves{"leaves"};

  LinearExpressionEvaluator(sc_core::sc_module_name name, array::PlaneShape shape);

 private:
  void step();

  array::LinearEvaluator trees_;
};

}  // namespace csgsim::pixel_planes
