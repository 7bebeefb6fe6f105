#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <systemc>

#include "hw/array/linear_evaluator.h"
#include "hw/array/stepped_evaluator.h"
#include "hw/pixel_planes/control_word.h"

namespace csgsim::pixel_planes {

/// The two multiplier trees (thesis fig. 7.1): coefficient bits in at the roots, bits of F out at every pixel. What
/// comes out is worked out of the coefficients, or of the bits in stepped trees' adders: at the same clocks.
class LinearExpressionEvaluator final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<RootWord> root{"root"};
  sc_core::sc_out<TreeWord> leaves{"leaves"};  ///< the registers at the pixels

  LinearExpressionEvaluator(sc_core::sc_module_name name, array::PlaneShape shape, unsigned register_levels,
                            std::optional<array::SteppedEvaluator> adders = std::nullopt);

  // As array::LinearEvaluator.
  [[nodiscard]] unsigned x_levels() const { return trees_.x_levels(); }
  [[nodiscard]] unsigned y_levels() const { return trees_.y_levels(); }
  [[nodiscard]] array::LevelProbe x_level(unsigned level, array::Place pixel) const {
    const array::RootBits& bits = root.read().bits;
    return adders_ ? adders_->x_level(level, pixel.x, bits) : trees_.x_level(level, pixel.x, bits);
  }
  [[nodiscard]] array::LevelProbe y_level(unsigned level, array::Place pixel) const {
    const array::RootBits& bits = root.read().bits;
    return adders_ ? adders_->y_level(level, pixel, bits) : trees_.y_level(level, pixel, bits);
  }

 private:
  void step();
  void step_adders(const array::RootBits& bits);

  array::LinearEvaluator trees_;
  std::optional<array::SteppedEvaluator> adders_;  ///< in place of them
  std::array<array::Words, 2> pixels_;             ///< in turn: one is read while the other is written
  std::size_t written_ = 0;                        ///< of these
};

}  // namespace csgsim::pixel_planes
