#pragma once

#include "host/csg/bit_string.h"
#include "host/emit/context.h"

namespace csgsim::emit {

/// Bits of the longest string that an operand of the topmost intersection takes. The operands are worked out one after
/// another, so that no more than that are needed; one that is a leaf needs none.
unsigned string_bits(const csg::ActiveTree& active);

/// Works out a string whose leaves are in the bits from `base` on, where E; the result is at `base`. `alu_bits`: of the
/// machine, for which it takes the fewest clocks.
void emit_string_levels(Broadcast& out, const csg::BitString& string, unsigned base, unsigned alu_bits);

}  // namespace csgsim::emit
