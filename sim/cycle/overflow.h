#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/isa/program.h"

namespace csgsim::cycle {

/// A linear expression, and the squares of the instruction before; zeros if there are none.
struct Expression {
  isa::Linear linear;
  isa::Linear squares;
};

/// What an instruction streams, if it has a linear expression whose sum has to fit.
std::optional<Expression> expression_of(const isa::Segment& segment, std::size_t index);

/// May the sum leave the expression's width in two's complement at a pixel of the region? Without squares: does it?
bool can_overflow(const Expression& expression, const isa::Region& region);

/// Enabled pixels of the region at which the sum does not fit the expression's width in two's complement.
/// Enable bits as in PixelState, but `row_words` words a row; none outside the region.
std::uint64_t count_overflows(const Expression& expression, const isa::Region& region,
                              std::span<const std::uint64_t> enable, std::size_t row_words);

}  // namespace csgsim::cycle
