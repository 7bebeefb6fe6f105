#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/array/step_log.h"

/// The loops over pixels, compiled for every vector unit and chosen at run time.
namespace csgsim::array::kernels {

/// Pixels are worked on in blocks of so many words, a cache line of each of a pixel's bits.
inline constexpr std::size_t block_words = 8;

/// Bit j of xx*x*x + a*x + c at every column x is row j of `columns`, `stride` words each; the words of a row of pixels
/// are repeated there until all blocks have theirs beside each other, wherever in a row they begin. A stream with x*y
/// has other bits in each row, and no such table.
struct StreamTable {
  const std::uint64_t* columns = nullptr;
  std::size_t stride = 0;
  std::uint64_t b = 0;
  std::uint64_t yy = 0;
  unsigned bits = 0;                ///< 1 to 64
  const Stream* crossed = nullptr;  ///< the stream, if it has x*y
};

/// Word i of block n is word n * block_words + i of the pixels, whose rows are `row_words` long. Of the pixel's bits
/// (PixelBits) bit k of block n is at `bits` + n * `stride` + k * block_words.
struct Blocks {
  std::uint64_t* bits = nullptr;
  std::size_t stride = 0;  ///< words
  std::uint64_t* enable = nullptr;
  const std::uint64_t* present = nullptr;
  std::size_t row_words = 1;
};

/// What of the steps counts.
struct Effects {
  bool enabled = true;  ///< they find the enable bits that are there and change them; else all are 0
  bool carry = true;
  bool latch = true;
  bool flag = true;
  bool has_flag = true;  ///< there are steps with the flag; else they need not be looked for
};

/// Carries out runs on those blocks. `tables`: of the streams.
void run(std::span<const Run> runs, std::span<const StreamTable> tables, const Blocks& blocks,
         std::span<const std::uint32_t> numbers, Effects effects);

/// Sets flags[n] to whether block n of a plane has any ones.
void find_ones(const std::uint64_t* plane, std::span<std::uint8_t> flags);

/// Ones in `words` words (a multiple of 8).
std::uint64_t count_ones(const std::uint64_t* plane, std::size_t words);

/// Whether any bit of `words` words (a multiple of 8) is 1.
bool any_ones(const std::uint64_t* plane, std::size_t words);

}  // namespace csgsim::array::kernels
