#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

/// Numbers of a Program's instructions, `i123` for people: from 0 on through all segments in order, whether or not an
/// instruction is carried out. For each segment that of its first; the last entry is the number of all.
inline std::vector<std::uint64_t> first_numbers(const Program& program) {
  std::vector<std::uint64_t> numbers{0};
  numbers.reserve(program.segments.size() + 1);
  for (const Segment& segment : program.segments) numbers.push_back(numbers.back() + segment.instructions.size());
  return numbers;
}

}  // namespace csgsim::isa
