#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/read/arguments.h"

namespace csgsim::read {

/// A vector of whole numbers below `points`.
std::vector<std::uint32_t> read_indices(const Arguments& arguments, ValueView list, std::size_t points);

}  // namespace csgsim::read
