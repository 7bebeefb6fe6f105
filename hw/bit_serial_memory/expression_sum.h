#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/bit_serial_memory/column_logic.h"
#include "hw/bit_serial_memory/row_map.h"
#include "hw/isa/instruction.h"

namespace csgsim::bit_serial_memory {

/// A term added to, or subtracted from, an expression in one pass. Bit i, from `first` on, is the row `rows[i -
/// first]`; or, if there are no rows, bit i of `multiple` in the columns where the row `coordinate` is 1. Bits above
/// the last row are 0.
struct Term {
  unsigned first = 0;
  bool subtracted = false;
  std::vector<Row> rows{};
  Row coordinate = 0;
  std::uint64_t multiple = 0;

  bool operator==(const Term&) const = default;
};

/// Decomposes coefficient * coordinate, modulo 2^width, into terms; `coordinate` lists the rows of the coordinate's
/// bits. Chooses the form with fewer bits to add: the coordinate once per nonzero digit of the coefficient (digits 1 or
/// -1, as few as possible), or the coefficient once per bit of the coordinate.
std::vector<Term> terms_of(std::int64_t coefficient, std::span<const Row> coordinate, unsigned width);

/// The bits of F that an instruction needs: those from `first` on, or only the sign.
struct RequiredBits {
  unsigned first = 0;
  bool sign_alone = false;
};

/// Computes A*x + B*y + C, modulo 2^width, from the rows of x and y. Returns the bits of the sum; bits that are not
/// required may be wrong.
std::vector<Bit> sum_expression(const isa::Linear& linear, RequiredBits required, ColumnLogic& logic);

}  // namespace csgsim::bit_serial_memory
