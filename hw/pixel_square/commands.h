#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/instruction.h"
#include "hw/isa/link_word.h"
#include "hw/isa/program.h"

namespace csgsim::pixel_square {

/// SegmentStart, the instructions and SegmentEnd in words of a link; none without instructions.
std::vector<isa::LinkWord> commands_of(const isa::Region& region, std::span<const isa::Instruction> instructions,
                                       std::uint32_t link_width);

}  // namespace csgsim::pixel_square
