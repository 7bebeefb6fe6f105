#pragma once

#include <cstdint>

#include "hw/array/plane.h"

namespace csgsim::array {

/// Which bit of an instruction's stream is on a wire.
struct Token {
  static constexpr std::int16_t idle = -1;
  std::int16_t bit = idle;

  [[nodiscard]] constexpr bool active() const { return bit != idle; }
  constexpr bool operator==(const Token&) const = default;
};

/// A bit (0 to 63) of a*x + b*y + c in registers that every pixel, or every node of a tree, has one of: as all of them
/// follow from the coefficients, these stand for the bits. Of the coefficients at least the bits up to that one are
/// there, and it depends on no others. Without an active token the bits are 0.
struct StreamBit {
  Token token;
  std::uint64_t a = 0;
  std::uint64_t b = 0;
  std::uint64_t c = 0;

  [[nodiscard]] constexpr bool at(Place pixel) const {
    return token.active() && ((a * pixel.x + b * pixel.y + c) >> token.bit & 1U) != 0;
  }
  constexpr bool operator==(const StreamBit&) const = default;
};

}  // namespace csgsim::array
