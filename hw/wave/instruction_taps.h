#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/wave/tap.h"

namespace csgsim::wave {

/// The instruction that a part of a machine is at, in words: `PART.instruction` (hw/isa/instruction_numbers.h),
/// `.text`, `.purpose`, `.primitive` whose surface is drawn, `.against` the one it is compared with, `.effect` that it
/// is paid for by. `at` tells its number; the Program has to live as long as the taps.
std::vector<Tap> instruction_taps(const std::string& part, const isa::Program& program, std::function<Number()> at);

}  // namespace csgsim::wave
