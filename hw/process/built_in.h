// The built-in processes.
// Used by load.cpp.
#pragma once

#include <span>

#include "hw/machines/built_in.h"

namespace csgsim::process {

/// Descriptions of the built-in processes.
std::span<const machines::BuiltIn> built_in_processes();

}  // namespace csgsim::process
