#pragma once

#include "hw/bit_serial_memory/column_logic.h"
#include "hw/isa/instruction.h"

namespace csgsim::bit_serial_memory {

/// Writes the row commands of the instruction `root` for a field of 2w + 1 bits: for each bit of the root, highest
/// first, 4q + 1 is subtracted from the remainder unless it is greater.
void write_root(isa::Field field, ColumnLogic& logic);

}  // namespace csgsim::bit_serial_memory
