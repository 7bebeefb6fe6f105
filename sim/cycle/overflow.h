// Counts sums that exceed their width, which the clocked machines do not detect.
// Used by relay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/isa/program.h"

namespace csgsim::cycle {

/// A linear expression, and the quadratic terms streamed by the previous instruction (zeros if none).
struct Expression {
  isa::Linear linear;
  isa::Linear squares;
};

/// The expression that an instruction streams, if it has one whose sum must fit.
std::optional<Expression> find_expression(const isa::Segment& segment, std::size_t index);

/// Whether the sum may exceed the expression's width in two's complement at a pixel of the region; exact without
/// squares.
bool can_overflow(const Expression& expression, const isa::Region& region);

/// Number of enabled pixels of the region at which the sum exceeds the expression's width in two's complement. Enable
/// bits are as in PixelState, but with `row_words` words per row, and are 0 outside the region.
std::uint64_t count_overflows(const Expression& expression, const isa::Region& region,
                              std::span<const std::uint64_t> enable, std::size_t row_words);

}  // namespace csgsim::cycle
