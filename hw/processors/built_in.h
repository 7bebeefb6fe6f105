#pragma once

#include <span>

#include "hw/machines/built_in.h"

namespace csgsim::processors {

/// The processors' descriptions that come with csgsim.
std::span<const machines::BuiltIn> built_in_processors();

}  // namespace csgsim::processors
