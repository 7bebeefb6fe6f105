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

/// What waves show of an array of pixel processors below its trees, on whatever machine it is.
namespace csgsim::pixel_planes {

/// Whether coefficients enter the trees, `PART.state`; their bits: `PART.a`, `.b`, `.c`, and the number of the first,
/// `.bit`; of degree 2 also `.xx`, `.xy`, `.yy`; where several are side by side also how many, `.bits`.
std::vector<wave::Tap> root_taps(const std::string& part, const PixelPipeline& pipeline, array::TreeForm trees);

/// The control word at the pixels, with the instruction that it is a step of: `PART.instruction`, `.text`, ...,
/// `.function`, `.read_x`, `.read_y`, `.write`, `.bits`, `.constant`. Where the trees bring several bits in a clock
/// also
/// `.first`, that of them which the step begins with, and `.function` names what is done with the bits beyond the field
/// and with the sign too, as in `compare+compare_with_0+sign_enable`; `.bits` counts the bits of the first of these.
/// `at` tells the instruction's number among all of the Program.
std::vector<wave::Tap> control_taps(const std::string& part, const PixelPipeline& pipeline, unsigned tree_bits,
                                    const isa::Program& program, std::function<wave::Number()> at);

/// Where a probed pixel is looked at, while `shows` says so; always, if that is null.
struct PixelPoint {
  const PixelPipeline& pipeline;
  array::Place place;  ///< of the array
  array::Place built;  ///< where the pixel processors have it
  std::function<bool()> shows;
  array::TreeForm trees;
};

/// Registers, memory ports and fields of the pixel, and the tree levels on its way: `pixel_X_Y.tree_bit`, `.carry`,
/// `.flag`, `.enable`, `.latch`, `.mem_read_x`, `.mem_read_y`, `.mem_written`, a tap a field, `.tree_x_3`, the number
/// of its first bit `.tree_x_3_bit`, `.tree_x_3_carry`; of degree 2 also `.tree_x_3_slope`, `_slope_carry`,
/// `_step_carry`, and in the X tree `_row_slope`, `_row_slope_carry`. Where the trees carry several bits of a stream
/// side by side, so do the taps of streams. Throws InputError for a level that the tree has not.
std::vector<wave::Tap> pixel_taps(wave::Pixel pixel, PixelPoint point, const isa::Program& program,
                                  std::span<const wave::TreeLevel> levels, unsigned alu_bits);

}  // namespace csgsim::pixel_planes
