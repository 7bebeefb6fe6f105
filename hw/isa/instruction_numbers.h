// Numbers of instructions within a Program.
// Used by hw/multi_processor, hw/pixel_square, hw/scan_line, hw/wave, sim/engine, sim/python, sim/story and sim/waves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

/// The number of the first instruction of each segment; the last entry is the total. Users see `i123`: instructions are
/// numbered from 0 through all segments in order, whether or not they are executed.
inline std::vector<std::uint64_t> first_instruction_numbers(const Program& program) {
  std::vector<std::uint64_t> numbers{0};
  numbers.reserve(program.segments.size() + 1);
  for (const Segment& segment : program.segments) numbers.push_back(numbers.back() + segment.instructions.size());
  return numbers;
}

}  // namespace csgsim::isa
