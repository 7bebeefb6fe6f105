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

/// What waves show of a renderer.
namespace csgsim::pixel_square {

/// `PART.state`, `.square`; `.controller` with the instruction of the control word that it puts on the wires; `.root`
/// of the trees; `.pixels` with the control word that has come to them. The names have to live as long as the taps.
std::vector<wave::Tap> renderer_taps(const std::string& part, const RendererParts& parts, const isa::Program& program,
                                     const systemc::SegmentNames& names);

/// Of a pixel of that segment, while the renderer has it: its instruction, registers and fields. Throws InputError for
/// a level that the trees have not.
std::vector<wave::Tap> pixel_taps(wave::Pixel pixel, std::uint32_t segment, const RendererParts& parts,
                                  const isa::Program& program, std::span<const wave::TreeLevel> levels,
                                  unsigned alu_bits);

/// The pixels hold the square of that segment, which is not being cleared.
bool has(const RendererParts& parts, std::uint32_t segment);

}  // namespace csgsim::pixel_square
