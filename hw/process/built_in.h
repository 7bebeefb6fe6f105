#pragma once

#include <span>

#include "hw/machines/built_in.h"

namespace csgsim::process {

/// The processes' descriptions that come with csgsim.
std::span<const machines::BuiltIn> built_in_processes();

}  // namespace csgsim::process
