// Tables of all kinds and built-in machines.
// Used by hw/kinds, sim/session and sim/studies.
#pragma once

#include <span>

#include "hw/machines/built_in.h"
#include "hw/machines/kind.h"

namespace csgsim::kinds {

/// All kinds of machines.
std::span<const machines::Kind* const> all();

/// Descriptions of the built-in machines.
std::span<const machines::BuiltIn> built_in();

}  // namespace csgsim::kinds
