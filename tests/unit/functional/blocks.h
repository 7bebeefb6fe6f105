#pragma once

#include <cstdint>
#include <vector>

#include "sim/functional/bit_plane.h"
#include "tests/unit/functional/pixels.h"

namespace csgsim::testing {

/// Words of enable bits, and a block of some of their rows and columns. Lane 64 * i + b belongs to bit b of word i.
struct Words {
  std::vector<std::uint64_t> words;
  std::size_t stride = 0;
  std::size_t first = 0;  ///< word of the block
  std::size_t columns = 0;
  std::size_t rows = 0;

  [[nodiscard]] sim::WordBlock block() { return {words.data() + first, stride, columns, rows}; }
  [[nodiscard]] std::size_t lanes() const { return words.size() * sim::word_bits; }
  [[nodiscard]] std::size_t first_lane() const { return first * sim::word_bits; }
  [[nodiscard]] bool at(std::size_t lane) const { return (words[lane / 64] >> lane % 64 & 1U) != 0; }
  void set(std::size_t lane, bool bit) {
    const std::uint64_t one = std::uint64_t{1} << lane % 64;
    words[lane / 64] = bit ? words[lane / 64] | one : words[lane / 64] & ~one;
  }

  /// Calls visit(lane, x, y) for every lane of the block; x and y count from its first pixel.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t y = 0; y < rows; ++y)
      for (std::size_t x = 0; x < columns * 64; ++x) visit(first_lane() + y * stride * 64 + x, x, y);
  }
};

inline Words any_words() {
  Words all;
  all.rows = between<std::size_t>(1, 4);
  all.columns = between<std::size_t>(1, 3);
  all.stride = all.columns + between<std::size_t>(0, 2);
  all.first = between<std::size_t>(0, 3);
  all.words.resize(all.first + all.stride * all.rows);
  for (std::uint64_t& word : all.words) word = any_word();
  return all;
}

/// Few different values, the least and the greatest of so many bits among them, so that lanes are often equal.
inline std::vector<std::uint32_t> any_lanes(std::size_t count, unsigned bits) {
  const auto most = static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
  const std::vector<std::uint32_t> some{0, most, most / 2, most / 2 + 1, static_cast<std::uint32_t>(any_word()) & most};
  std::vector<std::uint32_t> lanes(count);
  std::uint64_t random = any_word() | 1U;
  for (std::uint32_t& lane : lanes) {
    random = random * 6364136223846793005U + 1442695040888963407U;
    const std::uint64_t choice = random >> 33U;
    lane = choice % 8 < some.size() ? some[choice % 8] : static_cast<std::uint32_t>(choice >> 3U) & most;
  }
  return lanes;
}

}  // namespace csgsim::testing
