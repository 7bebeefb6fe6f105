// Bits of the pixels of a tile, in blocks of 8 x 8.
// Used throughout the functional engine.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace csgsim::functional {

// A segment is divided into tiles, and a tile into blocks of 8 x 8 pixels: one word holds one bit of each pixel of a
// block, row by row from the least significant bit, and one word holds one bit of each block of a tile in the same way.

inline constexpr std::uint32_t word_bits = 64;
inline constexpr std::uint32_t block_side = 8;                            ///< pixels
inline constexpr std::uint32_t blocks_per_side = 8;                       ///< blocks along a side of a tile
inline constexpr std::uint32_t tile_side = block_side * blocks_per_side;  ///< pixels
inline constexpr std::uint32_t blocks_per_tile = blocks_per_side * blocks_per_side;
inline constexpr std::uint32_t block_pixels = block_side * block_side;
inline constexpr std::uint32_t tile_pixels = tile_side * tile_side;

/// The block of a tile's pixel, and the position of the pixel's bit in the block's words.
constexpr unsigned block_of(std::uint32_t x, std::uint32_t y) {
  return y / block_side * blocks_per_side + x / block_side;
}
constexpr unsigned bit_of(std::uint32_t x, std::uint32_t y) { return y % block_side * block_side + x % block_side; }

/// Calls visit(number) for each 1 bit of the word, from the least significant one.
template <class Visit>
void each_bit(std::uint64_t word, const Visit& visit) {
  for (; word != 0; word &= word - 1) visit(static_cast<unsigned>(std::countr_zero(word)));
}

/// The existing pixels of a tile: a rectangle that starts at its first pixel, 64 x 64 except at the right and bottom
/// edges of the picture.
class TileShape {
 public:
  /// Each side has 1 to tile_side pixels.
  TileShape(std::uint32_t width, std::uint32_t height);

  [[nodiscard]] std::uint32_t width() const { return width_; }
  [[nodiscard]] std::uint32_t height() const { return height_; }
  [[nodiscard]] std::uint32_t area() const { return width_ * height_; }

  /// Blocks that contain a pixel.
  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }
  /// Blocks with all their pixels.
  [[nodiscard]] std::uint64_t whole() const { return whole_; }
  /// The existing pixels of a block.
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

/// One bit of every pixel of a tile. A block is all zeros, all ones, or mixed; only mixed ones have a valid word. Bits
/// of pixels that do not exist are 0.
class TileBits {
 public:
  [[nodiscard]] std::uint64_t any() const { return any_; }    ///< blocks that contain a 1
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

  /// Writes the word of a block; set_blocks must be called for it afterwards.
  void write_word(unsigned block, std::uint64_t word) { words_[block] = word; }
  /// Sets the state of those blocks: a block in `any` contains a 1, a block in `full` has only ones.
  void set_blocks(std::uint64_t blocks, std::uint64_t any, std::uint64_t full) {
    any_ = (any_ & ~blocks) | any;
    full_ = (full_ & ~blocks) | full;
  }

  void clear() { any_ = full_ = 0; }
  void fill(const TileShape& shape) { any_ = full_ = shape.blocks(); }
  void assign(const TileBits& other);
  /// Clears these blocks.
  void clear_blocks(std::uint64_t blocks) {
    any_ &= ~blocks;
    full_ &= ~blocks;
  }
  /// Sets all bits of these blocks, which must have pixels.
  void fill_blocks(std::uint64_t blocks) {
    any_ |= blocks;
    full_ |= blocks;
  }

 private:
  std::uint64_t any_ = 0;
  std::uint64_t full_ = 0;
  std::array<std::uint64_t, blocks_per_tile> words_;
};

/// target := value(block) where e is 1, one word at a time.
template <class Value>
void write_where(const TileBits& e, TileBits& target, const TileShape& shape, const Value& value) {
  each_bit(e.any(), [&](unsigned block) {
    const std::uint64_t mask = e.word(block, shape);
    target.set_word(block, (target.word(block, shape) & ~mask) | (value(block) & mask), shape);
  });
}

/// The 8 bits of a row of a block's word, shifted to their position in a word of 64 pixels of a row.
constexpr std::uint64_t row_part(std::uint64_t block_word, std::uint32_t row, std::uint32_t block_column) {
  return (block_word >> (row * block_side) & 0xffU) << (block_column * block_side);
}

/// Writes the tile's bits as rows of 64 pixels, with `stride` words per row and one row per pixel row of the tile.
void write_rows(const TileBits& bits, const TileShape& shape, std::uint64_t* rows, std::size_t stride);
/// Sets the tile's bits from rows in the format of write_rows(); bits of pixels that do not exist must be 0.
void read_rows(const std::uint64_t* rows, std::size_t stride, const TileShape& shape, TileBits& bits);

}  // namespace csgsim::functional
