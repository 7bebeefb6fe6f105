#pragma once

#include <span>

#include "hw/machines/built_in.h"
#include "hw/machines/kind.h"

namespace csgsim::kinds {

/// Every kind of machine that comes with csgsim.
std::span<const machines::Kind* const> all();

/// The machines' descriptions that come with csgsim.
std::span<const machines::BuiltIn> built_in();

}  // namespace csgsim::kinds
