#pragma once

#include <cstdint>

#include "hw/array/plane.h"

namespace csgsim::array {

/// Which bits of an instruction's stream are on the wires that carry it.
struct Token {
  static constexpr std::int16_t idle = -1;
  std::int16_t bit = idle;  ///< the first of them
  std::uint16_t bits = 1;   ///< 1 to 32; fewer than there are wires where the stream ends

  [[nodiscard]] constexpr bool active() const { return bit != idle; }
  /// The bits of that value, if it is active; the first is the lowest.
  [[nodiscard]] constexpr std::uint32_t of(std::uint64_t value) const {
    return static_cast<std::uint32_t>(value >> bit & low_bits(bits));
  }
  constexpr bool operator==(const Token&) const = default;
};

/// xx*x*x + xy*x*y + yy*y*y + a*x + b*y + c modulo 2^64.
template <class Coefficients>
constexpr std::uint64_t value_at(const Coefficients& of, std::uint64_t x, std::uint64_t y) {
  return (of.xx * x + of.xy * y + of.a) * x + (of.yy * y + of.b) * y + of.c;
}

/// The token's bits (of 0 to 63) of xx*x*x + xy*x*y + yy*y*y + a*x + b*y + c in registers that every pixel, or every
/// node of a tree, has: as all of them follow from the coefficients, these stand for the bits. Of the coefficients at
/// least the bits up to the token's last are there, and they depend on no others. Without an active token the bits are
/// 0. Below trees of degree 1 the first three are 0.
struct StreamBit {
  Token token;
  std::uint64_t a = 0;
  std::uint64_t b = 0;
  std::uint64_t c = 0;
  std::uint64_t xx = 0;
  std::uint64_t xy = 0;
  std::uint64_t yy = 0;

  /// The first is the lowest.
  [[nodiscard]] constexpr std::uint32_t at(Place pixel) const {
    return token.active() ? token.of(value_at(*this, pixel.x, pixel.y)) : 0;
  }
  constexpr bool operator==(const StreamBit&) const = default;
};

}  // namespace csgsim::array
