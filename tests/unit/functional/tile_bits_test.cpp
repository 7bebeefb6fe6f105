#include "sim/functional/tile_bits.h"

#include "sim/functional/lane_kernels.h"
#include "tests/support/test.h"
#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;
using functional::TileBits;
using functional::TileShape;

namespace {

std::uint32_t ones(const Bits& bits) {
  std::uint32_t ones = 0;
  bits.each([&](std::uint32_t x, std::uint32_t y) { ones += bits.at(x, y) != 0 ? 1U : 0U; });
  return ones;
}

/// Applies a random operation to the bits and to their reference.
void do_any(TileBits& bits, Bits& pixels, const TileShape& shape) {
  const std::uint64_t blocks = any_word() & shape.blocks();
  const auto set_blocks = [&](char bit) {
    pixels.set_each([&](std::uint32_t x, std::uint32_t y) {
      return (blocks >> functional::block_of(x, y) & 1U) != 0 ? bit : pixels.at(x, y);
    });
  };
  switch (between(0, 7)) {
    case 0: pixels = set_random(bits, shape); break;
    case 1:
      bits.clear();
      pixels = Bits(shape);
      break;
    case 2:
      bits.fill(shape);
      pixels.set_each([](std::uint32_t, std::uint32_t) { return char{1}; });
      break;
    case 3:
      bits.clear_blocks(blocks);
      set_blocks(0);
      break;
    case 4:
      bits.fill_blocks(blocks);
      set_blocks(1);
      break;
    case 5: {
      TileBits other;
      pixels = set_random(other, shape);
      bits.assign(other);
      break;
    }
    default: {
      TileBits where;
      TileBits value;
      const Bits mask = set_random(where, shape);
      const Bits values = set_random(value, shape);
      functional::write_where(where, bits, shape, [&](unsigned block) { return value.word(block, shape); });
      pixels.set_each(
          [&](std::uint32_t x, std::uint32_t y) { return mask.at(x, y) != 0 ? values.at(x, y) : pixels.at(x, y); });
    }
  }
}

}  // namespace

TEST_CASE("a tile contains the pixels of its area in one block each") {
  CHECK(rc::check([] {
    const TileShape shape = any_shape();
    std::uint32_t area = 0;
    for (unsigned block = 0; block < functional::blocks_per_tile; ++block) {
      const auto count = static_cast<std::uint32_t>(std::popcount(shape.pixels(block)));
      RC_ASSERT((shape.blocks() >> block & 1U) == (count > 0 ? 1U : 0U));
      RC_ASSERT((shape.whole() >> block & 1U) == (count == functional::block_pixels ? 1U : 0U));
      area += count;
    }
    RC_ASSERT(area == shape.width() * shape.height());
    RC_ASSERT(area == shape.area());
    for (std::uint32_t y = 0; y < shape.height(); ++y)
      for (std::uint32_t x = 0; x < shape.width(); ++x)
        RC_ASSERT((shape.pixels(functional::block_of(x, y)) >> functional::bit_of(x, y) & 1U) == 1U);
  }));
}

TEST_CASE("bits of a tile match its pixels after any operations") {
  CHECK(rc::check([] {
    const TileShape shape = any_shape();
    TileBits bits;
    Bits pixels(shape);
    const int steps = between(1, 12);
    for (int i = 0; i < steps; ++i) {
      do_any(bits, pixels, shape);
      RC_ASSERT(bits_of(bits, shape) == pixels);
      RC_ASSERT(functional::count_ones(bits, shape) == ones(pixels));
    }
  }));
}

TEST_CASE("bits of a tile survive the conversion to rows of words and back") {
  CHECK(rc::check([] {
    const TileShape shape = any_shape();
    const auto stride = between<std::size_t>(1, 4);
    TileBits bits;
    const Bits pixels = set_random(bits, shape);
    std::vector<std::uint64_t> rows(shape.height() * stride, 0x5555U);
    functional::write_rows(bits, shape, rows.data(), stride);
    pixels.each([&](std::uint32_t x, std::uint32_t y) {
      RC_ASSERT((rows[y * stride] >> x & 1U) == (pixels.at(x, y) != 0 ? 1U : 0U));
    });
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i % stride != 0) RC_ASSERT(rows[i] == 0x5555U);
      if (i % stride == 0 && shape.width() < 64) RC_ASSERT(rows[i] >> shape.width() == 0U);
    }
    TileBits again;
    set_random(again, shape);
    functional::read_rows(rows.data(), stride, shape, again);
    RC_ASSERT(bits_of(again, shape) == pixels);
  }));
}
