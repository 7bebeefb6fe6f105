// A word of up to 256 bits on a link.
// Used by hw.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace csgsim::isa {

/// The word that a link carries in one clock: up to 256 bits, bit 0 on its first wire. Bits beyond the link's width are
/// 0.
struct LinkWord {
  static constexpr unsigned max_bits = 256;

  std::array<std::uint64_t, max_bits / 64> bits{};

  /// `bit_count` bits (0 to 64) from bit `first_bit`, as an unsigned number. They must end within max_bits.
  [[nodiscard]] constexpr std::uint64_t number(unsigned first_bit, unsigned bit_count) const {
    if (bit_count == 0) return 0;
    const unsigned place = first_bit % 64;
    std::uint64_t value = bits[first_bit / 64] >> place;
    if (place + bit_count > 64) value |= bits[first_bit / 64 + 1] << (64 - place);
    return bit_count == 64 ? value : value & ((std::uint64_t{1} << bit_count) - 1);
  }

  /// Stores a number of `bit_count` bits (0 to 64); the bits at its place must be zero.
  constexpr void put(unsigned first_bit, unsigned bit_count, std::uint64_t value) {
    if (bit_count == 0) return;
    const unsigned place = first_bit % 64;
    bits[first_bit / 64] |= value << place;
    if (place + bit_count > 64) bits[first_bit / 64 + 1] |= value >> (64 - place);
  }

  /// `bit_count` bits from bit `first_bit`, moved down to bit 0; bits beyond max_bits are 0.
  [[nodiscard]] constexpr LinkWord slice(unsigned first_bit, unsigned bit_count) const {
    LinkWord out;
    const unsigned end = std::min(first_bit + bit_count, max_bits);
    for (unsigned at = first_bit; at < end; at += 64) {
      const unsigned taken = std::min(64U, end - at);
      out.put(at - first_bit, taken, number(at, taken));
    }
    return out;
  }

  /// Stores the first `bit_count` bits of a word; the bits at their place must be zero. Bits beyond max_bits are lost.
  constexpr void put(unsigned first_bit, unsigned bit_count, const LinkWord& word) {
    const unsigned room = std::min(bit_count, max_bits - first_bit);
    for (unsigned at = 0; at < room; at += 64) {
      const unsigned taken = std::min(64U, room - at);
      put(first_bit + at, taken, word.number(at, taken));
    }
  }

  constexpr bool operator==(const LinkWord&) const = default;
};

}  // namespace csgsim::isa
