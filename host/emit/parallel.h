// Classification of all leaves into a bit string, evaluated level by level.
// Used by the strategy parallel and its test.
#pragma once

#include "host/csg/bit_string.h"
#include "host/emit/context.h"

namespace csgsim::emit {

/// Bits of the longest string of an operand of the topmost intersection. Operands are evaluated one after another and
/// share these bits; an operand that is a leaf needs none.
unsigned string_bits(const csg::ActiveTree& active);

/// Evaluates a string, whose leaves are the bits from `base` on, where E is 1; the result is written to `base`.
/// `alu_bits` is the ALU width of the machine, for which the number of clocks is minimized.
void emit_string_levels(Broadcast& out, const csg::BitString& string, unsigned base, unsigned alu_bits);

}  // namespace csgsim::emit
