#pragma once

#include <systemc>

#include "hw/array/linear_evaluator.h"
#include "hw/pixel_planes/control_word.h"

namespace csgsim::pixel_planes {

/// The two multiplier trees (thesis fig. 7.1): coefficient bits in at the roots, a bit of F out at every pixel.
class LinearExpressionEvaluator final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<RootWord> root{"root"};
  sc_core::sc_out<TreeWord> leaves{"leaves"};  ///< the registers at the pixels

  LinearExpressionEvaluator(sc_core::sc_module_name name, array::PlaneShape shape);

  // As array::LinearEvaluator.
  [[nodiscard]] unsigned x_levels() const { return trees_.x_levels(); }
  [[nodiscard]] unsigned y_levels() const { return trees_.y_levels(); }
  [[nodiscard]] array::LevelProbe x_level(unsigned level, array::Place pixel) const {
    return trees_.x_level(level, pixel.x, root.read().bits);
  }
  [[nodiscard]] array::LevelProbe y_level(unsigned level, array::Place pixel) const {
    return trees_.y_level(level, pixel, root.read().bits);
  }

 private:
  void step();

  array::LinearEvaluator trees_;
};

}  // namespace csgsim::pixel_planes
