#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_square/renderer.h"
#include "hw/systemc/segment_names.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

/// Wave taps of a renderer.
namespace csgsim::pixel_square {

/// Taps `PART.state` and `.square`; `.controller`, the instruction of the control word on the wires; `.root`, the
/// coefficients that enter the trees; `.pixels`, the control word that has reached the pixels. The names must outlive
/// the taps.
std::vector<wave::Tap> renderer_taps(const std::string& part, const RendererParts& parts, const isa::Program& program,
                                     const systemc::SegmentNames& names);

/// Taps of a pixel of the given segment: its instruction, registers and fields, shown while the renderer draws the
/// segment. Throws InputError for a level that the trees do not have.
std::vector<wave::Tap> pixel_taps(wave::Pixel pixel, std::uint32_t segment, const RendererParts& parts,
                                  const isa::Program& program, std::span<const wave::TreeLevel> levels,
                                  unsigned alu_bits);

/// Whether the pixels hold the square of the given segment and are not being cleared.
bool holds_segment(const RendererParts& parts, std::uint32_t segment);

}  // namespace csgsim::pixel_square
