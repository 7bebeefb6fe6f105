#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/bit_serial_memory/column_logic.h"
#include "hw/bit_serial_memory/row_map.h"
#include "hw/isa/instruction.h"

namespace csgsim::bit_serial_memory {

/// What is added to, or subtracted from, an expression in one go: bit i, from `first` on, is the row `rows[i - first]`
/// or, without rows, bit i of `multiple` in the columns where the row `coordinate` is 1. Above the last row it is 0.
struct Term {
  unsigned first = 0;
  bool subtracted = false;
  std::vector<Row> rows{};
  Row coordinate = 0;
  std::uint64_t multiple = 0;

  bool operator==(const Term&) const = default;
};

/// The terms of coefficient * coordinate, modulo 2^width, whose bits are in these rows. Of two ways that with fewer
/// bits to add: the coordinate once for each digit of the coefficient (1 or -1, as few as there can be), or the
/// coefficient once for each bit of the coordinate.
std::vector<Term> terms_of(std::int64_t coefficient, std::span<const Row> coordinate, unsigned width);

/// Which bits of F are wanted: those from `first` on, or the sign alone.
struct Wanted {
  unsigned first = 0;
  bool sign_alone = false;
};

/// Sums A*x + B*y + C, modulo 2^width, of the rows of x and y. Returns its bits; those that are not wanted need not be
/// right.
std::vector<Bit> sum_expression(const isa::Linear& linear, Wanted wanted, ColumnLogic& logic);

}  // namespace csgsim::bit_serial_memory
