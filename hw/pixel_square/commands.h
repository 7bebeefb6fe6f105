#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "hw/isa/link_word.h"
#include "hw/isa/program.h"

namespace csgsim::pixel_square {

/// Encodes SegmentStart, the instructions and SegmentEnd as link words of `link_width` bits. Returns no words if there
/// are no instructions.
std::vector<isa::LinkWord> encode_square(const isa::Region& region, std::span<const isa::Instruction> instructions,
                                         std::uint32_t link_width);

}  // namespace csgsim::pixel_square
