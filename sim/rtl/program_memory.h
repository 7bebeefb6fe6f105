#pragma once

#include <cstddef>
#include <string>

#include "hw/isa/program.h"

namespace csgsim::rtl {

/// A Program as memory files for $readmemh, a word a line in hexadecimal digits.
struct ProgramMemory {
  std::string words;   ///< of the link, in the order in which they are sent
  std::string begins;  ///< for each instruction, and one more, the number of the word from which on it is sent
  std::size_t word_count = 0;
  std::size_t begin_count = 0;
};

/// The frame in words of that many bits. Throws as isa::encode does.
ProgramMemory program_memory(const isa::Program& program, unsigned link_width);

}  // namespace csgsim::rtl
