// Vectorized loops over bit planes.
// Used by hw/array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/array/step_log.h"

/// Loops over pixels, compiled for several vector instruction sets and selected at run time.
namespace csgsim::array::kernels {

/// Pixels are processed in blocks of this many words: one cache line for each bit of a pixel.
inline constexpr std::size_t block_words = 8;

/// Bit j of xx*x*x + a*x + c for every column x is row j of `columns`; rows are `stride` words apart. Each table
/// row repeats the words of a row of pixels, so that the words of a block are contiguous wherever the block begins. A
/// stream with x*y has different bits in each row of pixels, and no such table.
struct StreamTable {
  const std::uint64_t* columns = nullptr;
  std::size_t stride = 0;
  std::uint64_t b = 0;              ///< coefficient of y, the pixel's row
  std::uint64_t yy = 0;             ///< coefficient of y*y
  unsigned bits = 0;                ///< 1 to 64
  const Stream* crossed = nullptr;  ///< the stream itself if it has x*y
};

/// Memory layout of the pixels. Word i of block n is word n * block_words + i of a plane with rows of `row_words`
/// words. Bit k of PixelBits of block n is at `bits` + n * `stride` + k * block_words.
struct Blocks {
  std::uint64_t* bits = nullptr;
  std::size_t stride = 0;  ///< words
  std::uint64_t* enable = nullptr;
  const std::uint64_t* present = nullptr;
  std::size_t row_words = 1;
};

/// Selects the results that a run stores.
struct Effects {
  bool enabled = true;  ///< the enable bits are read and stored; if false, they are treated as 0
  bool carry = true;
  bool latch = true;
  bool flag = true;
  bool has_flag = true;  ///< false if no step uses the flag, which permits a faster loop
};

/// Executes the runs on the blocks with the given numbers. `tables`: one per stream.
void run(std::span<const Run> runs, std::span<const StreamTable> tables, const Blocks& blocks,
         std::span<const std::uint32_t> block_numbers, Effects effects);

/// Sets flags[n] to 1 if block n of a plane contains a 1, else to 0.
void find_ones(const std::uint64_t* plane, std::span<std::uint8_t> flags);

/// Number of 1 bits in the first `word_count` words (a multiple of 8).
std::uint64_t count_ones(const std::uint64_t* plane, std::size_t word_count);

/// Whether any bit of the first `word_count` words (a multiple of 8) is 1.
bool any_ones(const std::uint64_t* plane, std::size_t word_count);

}  // namespace csgsim::array::kernels
