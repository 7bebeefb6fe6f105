// Packs RGB colours into fields of 3 to 24 bits.
// Used by hw/division, host/effects, host/emit and sim.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace csgsim::isa {

inline constexpr unsigned minimum_colour_bits = 3;
inline constexpr unsigned max_colour_bits = 24;

/// Widths of red, green and blue in a colour field, red in the highest bits. If 3 does not divide the width, green gets
/// the first extra bit and red the second.
constexpr std::array<unsigned, 3> channel_widths(unsigned colour_bits) {
  return {colour_bits / 3 + (colour_bits % 3 == 2 ? 1 : 0), colour_bits / 3 + (colour_bits % 3 != 0 ? 1 : 0),
          colour_bits / 3};
}

/// A colour as stored in a field of `colour_bits` bits; components in [0, 1], clamped, rounded to nearest.
inline std::uint32_t pack_colour(const std::array<double, 3>& colour, unsigned colour_bits) {
  std::uint32_t packed = 0;
  const std::array<unsigned, 3> widths = channel_widths(colour_bits);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double top = static_cast<double>((1U << widths[channel]) - 1);
    const auto level = static_cast<std::uint32_t>(std::lround(std::clamp(colour[channel], 0.0, 1.0) * top));
    packed = packed << widths[channel] | level;
  }
  return packed;
}

/// Red, green and blue of a packed colour, 0 to 255, rounded to nearest.
constexpr std::array<std::uint8_t, 3> unpack_colour(std::uint32_t packed, unsigned colour_bits) {
  std::array<std::uint8_t, 3> colour{};
  const std::array<unsigned, 3> widths = channel_widths(colour_bits);
  for (std::size_t channel = 3; channel-- > 0;) {
    const std::uint32_t top = (1U << widths[channel]) - 1;
    const std::uint32_t level = packed & top;
    colour[channel] = static_cast<std::uint8_t>(top == 0 ? 0 : (level * 255U + top / 2) / top);
    packed >>= widths[channel];
  }
  return colour;
}

}  // namespace csgsim::isa
