#pragma once

#include <cstdint>

#include "tests/m68000/processor.h"

namespace csgsim::m68000 {

constexpr std::uint32_t bytes_of(Size size) { return static_cast<std::uint32_t>(size); }
constexpr std::uint32_t bits_of(Size size) { return 8 * bytes_of(size); }
constexpr std::uint32_t mask_of(Size size) { return 0xffff'ffffU >> (32 - bits_of(size)); }

/// Whether the highest bit of the value is set.
constexpr bool is_negative(std::uint32_t value, Size size) { return ((value >> (bits_of(size) - 1)) & 1U) != 0; }

/// The value with its sign extended to all higher bits.
constexpr std::uint32_t extended(std::uint32_t value, Size size) {
  return is_negative(value, size) ? value | ~mask_of(size) : value;
}

}  // namespace csgsim::m68000
