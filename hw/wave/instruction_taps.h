// Taps that describe an instruction.
// Used by hw/bit_serial_memory, hw/multi_processor, hw/pixel_planes, hw/pixel_square, hw/scan_line and sim/waves.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/wave/tap.h"

namespace csgsim::wave {

/// Taps that describe the current instruction of a part of a machine: `PART.instruction`
/// (hw/isa/instruction_numbers.h), `.text`, `.purpose`, `.primitive` (the primitive whose surface is drawn), `.against`
/// (the primitive compared with that one), and `.effect` (the effect to which the instruction is charged). `current`
/// returns the instruction's number; the Program must outlive the taps.
std::vector<Tap> instruction_taps(const std::string& part, const isa::Program& program,
                                  std::function<Number()> current);

}  // namespace csgsim::wave
