#include "tests/unit/functional/pixels.h"

#include <algorithm>

#include "sim/functional/lane_kernels.h"

namespace csgsim::testing {

std::uint64_t any_word() {
  const auto word = [] { return *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()); };
  switch (between(0, 6)) {
    case 0: return 0;
    case 1: return ~std::uint64_t{0};
    case 2: return word() & word() & word();
    case 3: return std::uint64_t{1} << between(0U, 64U);
    default: return word();
  }
}

functional::TileShape any_shape() {
  const auto side = [] { return *rc::gen::element<std::uint32_t>(1, 7, 8, 9, 63, 64, 64, between(1U, 65U)); };
  const std::uint32_t width = side();
  return {width, side()};
}

Bits bits_of(const functional::TileBits& bits, const functional::TileShape& shape) {
  Bits pixels(shape);
  for (unsigned block = 0; block < functional::blocks_per_tile; ++block) {
    const std::uint64_t word = bits.word(block, shape);
    RC_ASSERT((word & ~shape.pixels(block)) == 0U);
    RC_ASSERT((bits.any() >> block & 1U) == (word != 0 ? 1U : 0U));
    RC_ASSERT((bits.full() >> block & 1U) == (word != 0 && word == shape.pixels(block) ? 1U : 0U));
  }
  pixels.set_each([&](std::uint32_t x, std::uint32_t y) {
    return static_cast<char>(bits.word(functional::block_of(x, y), shape) >> functional::bit_of(x, y) & 1U);
  });
  return pixels;
}

Bits set_random(functional::TileBits& bits, const functional::TileShape& shape) {
  bits.clear();
  const std::uint64_t mixed = any_word() & shape.blocks();
  bits.fill_blocks(any_word() & shape.blocks());
  for (unsigned block = 0; block < functional::blocks_per_tile; ++block)
    if ((mixed >> block & 1U) != 0) bits.set_word(block, any_word() & shape.pixels(block), shape);
  return bits_of(bits, shape);
}

Numbers numbers_of(const functional::Lanes& lanes, const functional::TileShape& shape) {
  Numbers numbers(shape);
  numbers.set_each([&](std::uint32_t x, std::uint32_t y) {
    const unsigned block = functional::block_of(x, y);
    const std::uint32_t value = lanes.value(block, functional::bit_of(x, y));
    RC_ASSERT(lanes.least[block] <= value);
    RC_ASSERT(value <= lanes.greatest[block]);
    return value;
  });
  return numbers;
}

Numbers set_random(functional::Lanes& lanes, unsigned bits, const functional::TileShape& shape) {
  const auto most = static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
  const std::vector<std::uint32_t> some{0, most, most / 2, most / 2 + 1, static_cast<std::uint32_t>(any_word()) & most};
  const std::uint64_t constant = any_word();
  std::uint64_t random = any_word() | 1U;
  const auto next = [&] {
    random = random * 6364136223846793005U + 1442695040888963407U;
    const std::uint64_t choice = random >> 33U;
    return choice % 8 < some.size() ? some[choice % 8] : static_cast<std::uint32_t>(choice >> 3U) & most;
  };
  lanes.field = {0, static_cast<std::uint16_t>(bits)};
  for (unsigned block = 0; block < functional::blocks_per_tile; ++block) {
    if ((constant >> block & 1U) != 0) {
      lanes.set_constant(block, next());
      continue;
    }
    std::generate_n(lanes.block(block), functional::block_pixels, next);
    functional::find_bounds(lanes, block);
  }
  return numbers_of(lanes, shape);
}

}  // namespace csgsim::testing
