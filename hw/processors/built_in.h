// The built-in processors.
// Used by load.cpp and tests.
#pragma once

#include <span>

#include "hw/machines/built_in.h"

namespace csgsim::processors {

/// Descriptions of the built-in processors.
std::span<const machines::BuiltIn> built_in_processors();

}  // namespace csgsim::processors
