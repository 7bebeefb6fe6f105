#include "sim/functional/lane_kernels.h"

#include "tests/support/test.h"
#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;
using functional::Comparison;
using functional::Decide;
using functional::Lanes;

namespace {

/// A tile with enabled pixels, and two of its fields.
struct Tile {
  functional::TileShape shape = any_shape();
  unsigned bits = *rc::gen::element(1U, 20U, 32U, between(1U, 33U));
  functional::TileBits enable;
  Bits enabled = set_random(enable, shape);
  std::unique_ptr<Lanes> left = std::make_unique<Lanes>();
  std::unique_ptr<Lanes> right = std::make_unique<Lanes>();
  Numbers left_numbers = set_random(*left, bits, shape);
  Numbers right_numbers = set_random(*right, bits, shape);
  engine::Work work;

  functional::EnabledPixels pixels() {
    return {enable, shape, between(0, 3) == 0 ? Decide::by_pixel : Decide::by_block, work};
  }

  /// Sets left_numbers to number(x, y) where enabled and asserts that the lanes hold exactly that.
  template <class Number>
  void check_writes(const Number& number) {
    left_numbers.set_each(
        [&](std::uint32_t x, std::uint32_t y) { return enabled.at(x, y) != 0 ? number(x, y) : left_numbers.at(x, y); });
    RC_ASSERT(numbers_of(*left, shape) == left_numbers);
    RC_ASSERT(numbers_of(*right, shape) == right_numbers);
    RC_ASSERT(bits_of(enable, shape) == enabled);
  }
};

template <class Plane>
std::vector<Plane*> pointers_to(std::vector<functional::TileBits>& planes) {
  std::vector<Plane*> pointers;
  for (functional::TileBits& plane : planes) pointers.push_back(&plane);
  return pointers;
}

}  // namespace

TEST_CASE("a constant is written to exactly the enabled pixels") {
  CHECK(rc::check([] {
    Tile tile;
    const std::uint32_t value = tile.left_numbers.at(0, 0);
    functional::set_lanes(tile.pixels(), *tile.left, value);
    tile.check_writes([&](std::uint32_t, std::uint32_t) { return value; });
  }));
}

TEST_CASE("a field is copied at exactly the enabled pixels") {
  CHECK(rc::check([] {
    Tile tile;
    functional::copy_lanes(tile.pixels(), *tile.left, *tile.right);
    tile.check_writes([&](std::uint32_t x, std::uint32_t y) { return tile.right_numbers.at(x, y); });
  }));
}

TEST_CASE("a field is added at exactly the enabled pixels and drops the carry") {
  CHECK(rc::check([] {
    Tile tile;
    const std::uint32_t low_bits = ~std::uint32_t{0} >> (32 - tile.bits);
    functional::add_lanes(tile.pixels(), *tile.left, *tile.right, low_bits);
    tile.check_writes([&](std::uint32_t x, std::uint32_t y) {
      return (tile.left_numbers.at(x, y) + tile.right_numbers.at(x, y)) & low_bits;
    });
  }));
}

TEST_CASE("a comparison in lanes keeps enabled the pixels that satisfy it") {
  for (const Comparison comparison : {Comparison::less, Comparison::less_or_equal, Comparison::equal}) {
    CHECK(rc::check([&] {
      Tile tile;
      const std::uint32_t left = functional::compare_lanes(tile.pixels(), comparison, *tile.left, *tile.right);
      RC_ASSERT(left == functional::count_ones(tile.enable, tile.shape));
      tile.enabled.set_each([&](std::uint32_t x, std::uint32_t y) {
        const std::uint32_t l = tile.left_numbers.at(x, y);
        const std::uint32_t r = tile.right_numbers.at(x, y);
        const bool holds = comparison == Comparison::less            ? l < r
                           : comparison == Comparison::less_or_equal ? l <= r
                                                                     : l == r;
        return static_cast<char>(tile.enabled.at(x, y) != 0 && holds ? 1 : 0);
      });
      tile.check_writes([&](std::uint32_t x, std::uint32_t y) { return tile.left_numbers.at(x, y); });
    }));
  }
}

TEST_CASE("blocks of constant or distant values are decided without reading lanes") {
  const functional::TileShape shape(64, 64);
  auto left = std::make_unique<Lanes>();
  auto right = std::make_unique<Lanes>();
  for (unsigned block = 0; block < functional::blocks_per_tile; ++block) {
    left->set_constant(block, block);
    right->set_constant(block, 32);
  }
  for (const Decide decide : {Decide::by_block, Decide::by_pixel}) {
    functional::TileBits enable;
    enable.fill(shape);
    engine::Work work;
    functional::compare_lanes({enable, shape, decide, work}, Comparison::less, *left, *right);
    CHECK(enable.full() == 0xffffffffU);
    CHECK(enable.any() == 0xffffffffU);
    CHECK(work.words == (decide == Decide::by_block ? 0 : 64));
    CHECK(work.lanes == work.words * 64);
  }
}

TEST_CASE("bits of a field are gathered from lanes into planes for the selected blocks") {
  CHECK(rc::check([] {
    Tile tile;
    const unsigned first = between(0U, tile.bits);
    const std::uint64_t blocks = any_word();
    std::vector<functional::TileBits> planes(between(1U, tile.bits - first + 1));
    functional::gather_planes(*tile.left, tile.shape, blocks, first, pointers_to<functional::TileBits>(planes));
    for (unsigned i = 0; i < planes.size(); ++i) {
      bits_of(planes[i], tile.shape).each([&](std::uint32_t x, std::uint32_t y) {
        const unsigned block = functional::block_of(x, y);
        const bool bit = (planes[i].word(block, tile.shape) >> functional::bit_of(x, y) & 1U) != 0;
        const bool is_selected = (blocks >> block & 1U) != 0;
        RC_ASSERT(bit == (is_selected && (tile.left_numbers.at(x, y) >> (first + i) & 1U) != 0));
      });
    }
  }));
}

TEST_CASE("bits of planes are scattered into the lanes of a field for the selected blocks") {
  CHECK(rc::check([] {
    Tile tile;
    std::vector<functional::TileBits> planes(tile.bits);
    std::vector<Bits> bits;
    for (functional::TileBits& plane : planes) bits.push_back(set_random(plane, tile.shape));
    std::vector<const functional::TileBits*> there = pointers_to<const functional::TileBits>(planes);
    const unsigned missing = between(0U, 2 * tile.bits);
    if (missing < tile.bits) there[missing] = nullptr;
    const Numbers before = set_random(*tile.left, tile.bits, tile.shape);
    const std::uint64_t blocks = any_word();
    functional::scatter_planes(there, tile.shape, blocks, *tile.left);
    const Numbers numbers = numbers_of(*tile.left, tile.shape);
    numbers.each([&](std::uint32_t x, std::uint32_t y) {
      std::uint32_t expected = 0;
      for (unsigned bit = 0; bit < tile.bits; ++bit)
        if (bit != missing && bits[bit].at(x, y) != 0) expected |= std::uint32_t{1} << bit;
      const bool is_made = (blocks >> functional::block_of(x, y) & 1U) != 0;
      RC_ASSERT(numbers.at(x, y) == (is_made ? expected : before.at(x, y)));
    });
  }));
}
