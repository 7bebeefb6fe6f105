// Finds the running program's file.
// Used by sim/suite and sim/viewer.
#pragma once

#include <string>

namespace csgsim::system {

/// Path of the running program. Throws InputError if /proc is not mounted.
std::string own_program();

}  // namespace csgsim::system
