#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/linear_expression_evaluator.h"
#include "hw/pixel_planes/pixel_processors.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

/// What waves show of an array of pixel processors below its trees, on whatever machine it is.
namespace csgsim::pixel_planes {

/// Bits of the coefficients as they enter the trees: `PART.a`, `.b`, `.c`, `.bit`; of degree 2 also `.xx`, `.xy`,
/// `.yy`.
std::vector<wave::Tap> root_taps(const std::string& part, const sc_core::sc_signal<RootWord>& root, unsigned degree);

/// The control word at the pixels, with the instruction that it is a step of: `PART.instruction`, `.text`, ...,
/// `.function`, `.read_x`, `.read_y`, `.write`, `.bits`, `.constant`. `at` tells the instruction's number among all of
/// the Program.
std::vector<wave::Tap> control_taps(const std::string& part, const sc_core::sc_signal<ControlWord>& control,
                                    const isa::Program& program, std::function<wave::Number()> at);

/// Where a probed pixel is looked at, while `shows` says so; always, if that is null.
struct PixelPoint {
  const PixelProcessors& processors;
  const LinearExpressionEvaluator& evaluator;
  const sc_core::sc_signal<ControlWord>& control;  ///< at the pixels
  array::Place place;                              ///< of the array
  array::Place built;                              ///< where the pixel processors have it
  std::function<bool()> shows;
  unsigned degree = 1;  ///< of the expressions
};

/// Registers, memory ports and fields of the pixel, and the tree levels on its way: `pixel_X_Y.tree_bit`, `.carry`,
/// `.flag`, `.enable`, `.latch`, `.mem_read_x`, `.mem_read_y`, `.mem_written`, a tap a field, `.tree_x_3`,
/// `.tree_x_3_bit`, `.tree_x_3_carry`; of degree 2 also `.tree_x_3_slope`, `_slope_carry`, `_step_carry`, and in the X
/// tree
/// `_row_slope`, `_row_slope_carry`. Throws InputError for a level that the tree has not.
std::vector<wave::Tap> pixel_taps(wave::Pixel pixel, PixelPoint point, const isa::Program& program,
                                  std::span<const wave::TreeLevel> levels, unsigned alu_bits);

}  // namespace csgsim::pixel_planes
