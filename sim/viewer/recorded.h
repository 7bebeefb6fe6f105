#pragma once

#include <span>
#include <string>

#include "hw/isa/program.h"

namespace csgsim::viewer {

/// What `csgsim wave` prints of the Program, with these options besides its name and its output: recorded in a process
/// of its own, since SystemC elaborates once a process. Throws InputError with what that says, or where it takes longer
/// than three minutes, or prints more than 512 MB.
std::string recorded(const isa::Program& program, std::span<const std::string> options);

}  // namespace csgsim::viewer
