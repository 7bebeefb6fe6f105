#pragma once

#include <string_view>

#include "host/emit/options.h"

namespace csgsim::studies {

/// Whether a strategy has a stack whose bits are chosen.
inline bool has_stack_bits(std::string_view name) { return name == emit::name_of(emit::Strategy::bits); }

}  // namespace csgsim::studies
