// Bits of an expression's stream on wires and in registers.
// Used by hw/array.
#pragma once

#include <cstdint>

#include "hw/array/plane.h"

namespace csgsim::array {

/// Selects the bits of an instruction's stream that are on a set of wires in one clock.
struct Token {
  static constexpr std::int16_t idle = -1;
  std::int16_t bit = idle;  ///< index of the first bit
  std::uint16_t bits = 1;   ///< number of bits, 1 to 32; less than the number of wires at the end of a stream

  [[nodiscard]] constexpr bool active() const { return bit != idle; }
  /// The token's bits of a value, the first lowest; the token must be active.
  [[nodiscard]] constexpr std::uint32_t of(std::uint64_t value) const {
    return static_cast<std::uint32_t>(value >> bit & low_bits(bits));
  }
  constexpr bool operator==(const Token&) const = default;
};

/// xx*x*x + xy*x*y + yy*y*y + a*x + b*y + c modulo 2^64.
template <class Coefficients>
constexpr std::uint64_t value_at(const Coefficients& coefficients, std::uint64_t x, std::uint64_t y) {
  return (coefficients.xx * x + coefficients.xy * y + coefficients.a) * x + (coefficients.yy * y + coefficients.b) * y +
         coefficients.c;
}

/// The bits of xx*x*x + xy*x*y + yy*y*y + a*x + b*y + c that the token selects (bits 0 to 63), in registers at every
/// pixel or at every node of a tree. The coefficients represent these bits at all pixels. At least the coefficient bits
/// up to the token's last bit are valid, and the result depends on no others. Without an active token the bits are 0.
/// xx, xy and yy are 0 in trees of degree 1.
struct StreamBit {
  Token token;
  std::uint64_t a = 0;
  std::uint64_t b = 0;
  std::uint64_t c = 0;
  std::uint64_t xx = 0;
  std::uint64_t xy = 0;
  std::uint64_t yy = 0;

  /// The token's bits at a pixel, the first lowest.
  [[nodiscard]] constexpr std::uint32_t at(Place pixel) const {
    return token.active() ? token.of(value_at(*this, pixel.x, pixel.y)) : 0;
  }
  constexpr bool operator==(const StreamBit&) const = default;
};

}  // namespace csgsim::array
