#pragma once

#include <bit>
#include <cstdint>

namespace csgsim::division {

/// Number of bits of an unsigned number.
constexpr unsigned unsigned_width(std::uint64_t value) { return static_cast<unsigned>(std::bit_width(value)); }

/// Number of bits of a signed number in two's complement.
constexpr unsigned signed_width(std::int64_t value) {
  return unsigned_width(static_cast<std::uint64_t>(value < 0 ? ~value : value)) + 1;
}

}  // namespace csgsim::division
