#include "sim/functional/tile_bits.h"

#include <algorithm>

namespace csgsim::functional {

namespace {

constexpr std::uint64_t low_bits(std::uint32_t count) {
  return count >= word_bits ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// Number of pixels along a side of `size` that are in block `number` along it.
constexpr std::uint32_t extent(std::uint32_t size, std::uint32_t number) {
  const std::uint32_t first = number * block_side;
  return first >= size ? 0 : std::min(size - first, block_side);
}

}  // namespace

TileShape::TileShape(std::uint32_t width, std::uint32_t height) : width_(width), height_(height) {
  for (unsigned block = 0; block < blocks_per_tile; ++block) {
    const std::uint64_t pixels = pixels_at_side(block);
    const std::uint64_t one = std::uint64_t{1} << block;
    if (pixels != 0) blocks_ |= one;
    if (pixels == ~std::uint64_t{0}) whole_ |= one;
  }
}

std::uint64_t TileShape::pixels_at_side(unsigned block) const {
  constexpr std::uint64_t every_row = 0x0101010101010101U;
  const std::uint32_t columns = extent(width_, block % blocks_per_side);
  const std::uint32_t rows = extent(height_, block / blocks_per_side);
  return low_bits(columns) * every_row & low_bits(rows * block_side);
}

void TileBits::assign(const TileBits& other) {
  any_ = other.any_;
  full_ = other.full_;
  each_bit(mixed(), [&](unsigned block) { words_[block] = other.words_[block]; });
}

void write_rows(const TileBits& bits, const TileShape& shape, std::uint64_t* rows, std::size_t stride) {
  for (std::uint32_t first = 0; first < shape.height(); first += block_side) {
    const std::uint32_t count = std::min(block_side, shape.height() - first);
    std::array<std::uint64_t, block_side> parts{};
    const unsigned first_block = block_of(0, first);
    each_bit(bits.any() >> first_block & low_bits(blocks_per_side), [&](unsigned column) {
      const std::uint64_t word = bits.word(first_block + column, shape);
      for (std::uint32_t row = 0; row < block_side; ++row) parts[row] |= row_part(word, row, column);
    });
    for (std::uint32_t row = 0; row < count; ++row) rows[(first + row) * stride] = parts[row];
  }
}

void read_rows(const std::uint64_t* rows, std::size_t stride, const TileShape& shape, TileBits& bits) {
  bits.clear();
  each_bit(shape.blocks(), [&](unsigned block) {
    const std::uint32_t column = block % blocks_per_side;
    const std::uint32_t first = block / blocks_per_side * block_side;
    std::uint64_t word = 0;
    for (std::uint32_t row = 0; row < std::min(block_side, shape.height() - first); ++row)
      word |= (rows[(first + row) * stride] >> (column * block_side) & 0xffU) << (row * block_side);
    bits.set_word(block, word, shape);
  });
}

}  // namespace csgsim::functional
