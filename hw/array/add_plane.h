// Copies a bit plane into pixel values.
// Used by hw/pixel_planes and hw/pixel_square.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/array/plane.h"

namespace csgsim::array {

/// Sets bit `bit_index` of each pixel's value where `plane` is 1. `values` holds one row of pixels.
inline void add_plane(std::span<const std::uint64_t> plane, unsigned bit_index, std::span<std::uint32_t> values) {
  constexpr std::size_t at_once = 32;
  static constexpr auto ones = [] {
    std::array<std::uint32_t, at_once> each{};
    for (std::size_t i = 0; i < at_once; ++i) each[i] = std::uint32_t{1} << i;
    return each;
  }();
  const std::uint32_t bit = std::uint32_t{1} << bit_index;
  for (std::size_t first = 0; first < values.size(); first += at_once) {
    const auto bits = static_cast<std::uint32_t>(plane[first / word_bits] >> (first % word_bits));
    const std::size_t count = std::min(at_once, values.size() - first);
    for (std::size_t i = 0; i < count; ++i) values[first + i] |= (bits & ones[i]) != 0 ? bit : 0;
  }
}

}  // namespace csgsim::array
