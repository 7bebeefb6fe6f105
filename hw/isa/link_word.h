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
  static constexpr unsigned most_bits = 256;

  std::array<std::uint64_t, most_bits / 64> bits{};

  /// `count` bits (0 to 64) from bit `first`, as an unsigned number. They must end within most_bits.
  [[nodiscard]] constexpr std::uint64_t number(unsigned first, unsigned count) const {
    if (count == 0) return 0;
    const unsigned place = first % 64;
    std::uint64_t value = bits[first / 64] >> place;
    if (place + count > 64) value |= bits[first / 64 + 1] << (64 - place);
    return count == 64 ? value : value & ((std::uint64_t{1} << count) - 1);
  }

  /// Stores a number of `count` bits (0 to 64); the bits at its place must be zero.
  constexpr void put(unsigned first, unsigned count, std::uint64_t value) {
    if (count == 0) return;
    const unsigned place = first % 64;
    bits[first / 64] |= value << place;
    if (place + count > 64) bits[first / 64 + 1] |= value >> (64 - place);
  }

  /// `count` bits from bit `first`, moved down to bit 0; bits beyond most_bits are 0.
  [[nodiscard]] constexpr LinkWord slice(unsigned first, unsigned count) const {
    LinkWord out;
    const unsigned end = std::min(first + count, most_bits);
    for (unsigned at = first; at < end; at += 64) {
      const unsigned taken = std::min(64U, end - at);
      out.put(at - first, taken, number(at, taken));
    }
    return out;
  }

  /// Stores the first `count` bits of a word; the bits at their place must be zero. Bits beyond most_bits are lost.
  constexpr void put(unsigned first, unsigned count, const LinkWord& word) {
    const unsigned room = std::min(count, most_bits - first);
    for (unsigned at = 0; at < room; at += 64) {
      const unsigned taken = std::min(64U, room - at);
      put(first + at, taken, word.number(at, taken));
    }
  }

  constexpr bool operator==(const LinkWord&) const = default;
};

}  // namespace csgsim::isa
