#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace csgsim::functional {

// A segment's pixels are worked on in tiles, and a tile's in blocks of 8 x 8: one word holds a bit of each pixel of a
// block, row by row from its least significant bit, and one word holds a bit of each block of a tile in the same way.

inline constexpr std::uint32_t word_bits = 64;
inline constexpr std::uint32_t block_side = 8;                          ///< pixels
inline constexpr std::uint32_t blocks_a_side = 8;                       ///< of a tile
inline constexpr std::uint32_t tile_side = block_side * blocks_a_side;  ///< pixels
inline constexpr std::uint32_t blocks_a_tile = blocks_a_side * blocks_a_side;
inline constexpr std::uint32_t block_pixels = block_side * block_side;
inline constexpr std::uint32_t tile_pixels = tile_side * tile_side;

/// The block of a tile's pixel, and the pixel's bit in the block's words.
constexpr unsigned block_of(std::uint32_t x, std::uint32_t y) {
  return y / block_side * blocks_a_side + x / block_side;
}
constexpr unsigned bit_of(std::uint32_t x, std::uint32_t y) { return y % block_side * block_side + x % block_side; }

/// Calls visit(number) for each one of the word, from the least significant on.
template <class Visit>
void each_bit(std::uint64_t word, const Visit& visit) {
  for (; word != 0; word &= word - 1) visit(static_cast<unsigned>(std::countr_zero(word)));
}

/// Which of a tile's pixels there are: a rectangle from its first pixel on, 64 x 64 but at the picture's far sides.
class TileShape {
 public:
  /// 1 to tile_side pixels each way.
  TileShape(std::uint32_t width, std::uint32_t height);

  [[nodiscard]] std::uint32_t width() const { return width_; }
  [[nodiscard]] std::uint32_t height() const { return height_; }
  [[nodiscard]] std::uint32_t area() const { return width_ * height_; }

  /// Blocks that have a pixel.
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }
  /// Blocks that have all their pixels.
  [[nodiscard]] std::uint64_t whole() const { return whole_; }
  /// The pixels of a block.
  [[nodiscard]] std::uint64_t pixels(unsigned block) const {
    return (whole_ >> block & 1U) != 0 ? ~std::uint64_t{0} : pixels_at_side(block);
  }

 private:
  [[nodiscard]] std::uint64_t pixels_at_side(unsigned block) const;

  std::uint32_t width_;
  std::uint32_t height_;
  std::uint64_t blocks_ = 0;
  std::uint64_t whole_ = 0;
};

/// One bit of every pixel of a tile. A block is all zeros, all ones, or mixed; only mixed ones have a word written.
/// Bits where there is no pixel are 0.
class TileBits {
 public:
  [[nodiscard]] std::uint64_t any() const { return any_; }    ///< blocks with a one
  [[nodiscard]] std::uint64_t full() const { return full_; }  ///< blocks with ones at all their pixels
  [[nodiscard]] std::uint64_t mixed() const { return any_ & ~full_; }

  [[nodiscard]] std::uint64_t word(unsigned block, const TileShape& shape) const {
    const std::uint64_t one = std::uint64_t{1} << block;
    if ((any_ & one) == 0) return 0;
    return (full_ & one) != 0 ? shape.pixels(block) : words_[block];
  }
  void set_word(unsigned block, std::uint64_t word, const TileShape& shape) {
    const std::uint64_t one = std::uint64_t{1} << block;
    words_[block] = word;
    any_ = word != 0 ? any_ | one : any_ & ~one;
    full_ = word == shape.pixels(block) ? full_ | one : full_ & ~one;
  }

  /// Of a block that set_blocks is told of afterwards.
  void write_word(unsigned block, std::uint64_t word) { words_[block] = word; }
  /// What those blocks are from now on: with a one if in `any`, full of ones if in `full`.
  void set_blocks(std::uint64_t blocks, std::uint64_t any, std::uint64_t full) {
    any_ = (any_ & ~blocks) | any;
    full_ = (full_ & ~blocks) | full;
  }

  void clear() { any_ = full_ = 0; }
  void fill(const TileShape& shape) { any_ = full_ = shape.blocks(); }
  void assign(const TileBits& other);
  /// All zeros in these blocks.
  void clear_blocks(std::uint64_t blocks) {
    any_ &= ~blocks;
    full_ &= ~blocks;
  }
  /// All ones in these blocks, which have pixels.
  void fill_blocks(std::uint64_t blocks) {
    any_ |= blocks;
    full_ |= blocks;
  }

 private:
  std::uint64_t any_ = 0;
  std::uint64_t full_ = 0;
  std::array<std::uint64_t, blocks_a_tile> words_;
};

/// Where e: target := value(block), a word at a time.
template <class Value>
void write_where(const TileBits& e, TileBits& target, const TileShape& shape, const Value& value) {
  each_bit(e.any(), [&](unsigned block) {
    const std::uint64_t mask = e.word(block, shape);
    target.set_word(block, (target.word(block, shape) & ~mask) | (value(block) & mask), shape);
  });
}

/// The 8 bits of a row of a block's word, to where they are in a word of 64 pixels of a row.
constexpr std::uint64_t row_part(std::uint64_t block_word, std::uint32_t row, std::uint32_t block_column) {
  return (block_word >> (row * block_side) & 0xffU) << (block_column * block_side);
}

/// The tile's bits as rows of 64 pixels, `stride` words from one to the next; as many rows as the tile has.
void write_rows(const TileBits& bits, const TileShape& shape, std::uint64_t* rows, std::size_t stride);
/// The other way; bits where there is no pixel have to be 0.
void read_rows(const std::uint64_t* rows, std::size_t stride, const TileShape& shape, TileBits& bits);

}  // namespace csgsim::functional
