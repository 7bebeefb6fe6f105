// Memory files of a Program for $readmemh.
// Used by design.cpp.
#pragma once

#include <cstddef>
#include <string>

#include "hw/isa/program.h"

namespace csgsim::rtl {

/// A Program as memory files for $readmemh, one hexadecimal word per line.
struct ProgramMemory {
  std::string words;   ///< words of the link, in the order of sending
  std::string begins;  ///< number of the first word of each instruction, and the end
  std::size_t word_count = 0;
  std::size_t begin_count = 0;
};

/// The Program's frame as words of a link that is `link_width` bits wide. Throws as isa::encode does.
ProgramMemory program_memory(const isa::Program& program, unsigned link_width);

}  // namespace csgsim::rtl
