#pragma once

#include <cstdint>
#include <vector>

namespace csgsim::rtl {

/// A bit vector: bit i is bit i % 64 of word i / 64.
using Vector = std::vector<std::uint64_t>;

}  // namespace csgsim::rtl
