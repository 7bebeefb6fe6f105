#pragma once

#include <cstdint>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/isa/program.h"

namespace csgsim::sim {

/// Does A*x + B*y + C leave the expression's width in two's complement at any pixel of the region?
bool can_overflow(const isa::Linear& linear, const isa::Region& region);

/// Enabled pixels of the region at which A*x + B*y + C does not fit the expression's width in two's complement.
/// Enable bits as in PixelState, but `row_words` words a row; none outside the region.
std::uint64_t count_overflows(const isa::Linear& linear, const isa::Region& region,
                              std::span<const std::uint64_t> enable, std::size_t row_words);

}  // namespace csgsim::sim
