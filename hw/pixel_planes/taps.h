// Wave taps of trees, control words and pixels.
// Used by hw/pixel_planes and hw/pixel_square.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/control_word.h"
#include "hw/pixel_planes/pixel_pipeline.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

// Wave taps of an array of pixel processors and its trees, shared by several kinds of machines.
namespace csgsim::pixel_planes {

/// Taps of the coefficients that enter the trees: `PART.state`; the coefficient bits `PART.a`, `.b`, `.c`, and the
/// number of the first bit, `.bit`; in degree 2 also `.xx`, `.xy`, `.yy`; if several bits enter in parallel also their
/// number, `.bits`.
std::vector<wave::Tap> root_taps(const std::string& part, const PixelPipeline& pipeline, array::TreeForm trees);

/// Taps of the control word at the pixels and its instruction: `PART.instruction`, `.text`, ..., `.function`,
/// `.read_x`, `.read_y`, `.write`, `.bits`, `.constant`. If the trees deliver several bits per clock there is also
/// `.first`, the first bit that the step uses; `.function` then also names the functions of the bits beyond the field
/// and of the sign, as in `compare+compare_with_0+sign_enable`, and `.bits` is the number of bits for the first of
/// these functions. `at` returns the instruction's number within the Program.
std::vector<wave::Tap> control_taps(const std::string& part, const PixelPipeline& pipeline, unsigned tree_bits,
                                    const isa::Program& program, std::function<wave::Number()> at);

/// A probed pixel. Its taps show values only while `shows` returns true, or always if `shows` is null.
struct PixelPoint {
  const PixelPipeline& pipeline;
  array::Place place;  ///< position in the array
  array::Place built;  ///< position among the simulated pixels
  std::function<bool()> shows;
  array::TreeForm trees;
};

/// Taps of the registers, memory ports and fields of a pixel, and of the tree levels on the path to it:
/// `pixel_X_Y.tree_bit`, `.carry`, `.flag`, `.enable`, `.latch`, `.mem_read_x`, `.mem_read_y`, `.mem_written`, one tap
/// per field, `.tree_x_3`, the number of its first bit `.tree_x_3_bit`, `.tree_x_3_carry`; in degree 2 also
/// `.tree_x_3_slope`, `_slope_carry`, `_step_carry`, and in the X tree `_row_slope`, `_row_slope_carry`. Taps of
/// streams show all bits that the trees carry in parallel. Throws InputError for a level that the tree does not have.
std::vector<wave::Tap> pixel_taps(wave::Pixel pixel, PixelPoint point, const isa::Program& program,
                                  std::span<const wave::TreeLevel> levels, unsigned alu_bits);

}  // namespace csgsim::pixel_planes
