#pragma once

#include <string>

#include "hw/isa/program_file.h"
#include "sim/shell/memory.h"

namespace csgsim::shell {

/// Reads a Program. Throws InputError, also where memory does not hold it.
inline isa::Program read_program(const std::string& path) {
  return with_memory_for("the Program " + path, [&] { return isa::load_program(path); });
}

}  // namespace csgsim::shell
