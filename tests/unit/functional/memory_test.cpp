#include "sim/functional/memory.h"

#include "tests/support/test.h"
#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;
using functional::Memory;
using functional::TileBits;
using functional::TileShape;
using isa::Field;

namespace {

constexpr unsigned memory_bits = 40;

/// Reference that stores every bit of every pixel separately.
class SlowMemory {
 public:
  explicit SlowMemory(const TileShape& shape) : shape_(shape), bits_(memory_bits, Bits(shape)) {}

  [[nodiscard]] Bits& bit(unsigned number) { return bits_[number]; }
  [[nodiscard]] std::uint32_t value(Field field, std::uint32_t x, std::uint32_t y) const {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < field.width; ++i) {
      if (bits_[field.base + i].at(x, y) != 0) value |= std::uint32_t{1} << i;
    }
    return value;
  }
  void write(Field field, std::uint32_t x, std::uint32_t y, std::uint32_t value) {
    for (unsigned i = 0; i < field.width; ++i) bits_[field.base + i].set(x, y, static_cast<char>(value >> i & 1U));
  }

 private:
  TileShape shape_;
  std::vector<Bits> bits_;
};

/// One of few overlapping fields, or any field.
Field any_field() {
  const auto base = between<std::uint16_t>(0, memory_bits);
  const auto width = between<std::uint16_t>(1, std::min<std::uint16_t>(32, memory_bits - base) + 1);
  return *rc::gen::element(Field{0, 20}, Field{8, 32}, Field{20, 20}, Field{0, 8}, Field{39, 1}, Field{base, width});
}

unsigned any_bit() { return *rc::gen::element(0U, 7U, 8U, 19U, 39U, between(0U, memory_bits)); }

bool is_in(std::uint64_t blocks, std::uint32_t x, std::uint32_t y) {
  return (blocks >> functional::block_of(x, y) & 1U) != 0;
}

/// Restores all blocks except the given ones.
void keep_others(functional::Lanes& lanes, const functional::Lanes& before, std::uint64_t blocks) {
  functional::each_bit(~blocks, [&](unsigned block) {
    lanes.least[block] = before.least[block];
    lanes.greatest[block] = before.greatest[block];
    std::copy_n(before.block(block), functional::block_pixels, lanes.block(block));
  });
}

void write_lanes(Memory& memory, SlowMemory& slow, Field field, const TileShape& shape) {
  const std::uint64_t blocks = any_word();
  functional::Lanes& lanes = memory.lanes(field, {blocks, blocks & any_word()});
  RC_ASSERT(lanes.field == field);
  const functional::Lanes before = lanes;
  const Numbers numbers = set_random(lanes, field.width, shape);
  lanes.field = field;
  keep_others(lanes, before, blocks);
  numbers.each([&](std::uint32_t x, std::uint32_t y) {
    if (is_in(blocks, x, y)) slow.write(field, x, y, numbers.at(x, y));
  });
}

void write_plane(Memory& memory, SlowMemory& slow, unsigned bit, const TileShape& shape) {
  const std::uint64_t blocks = any_word() & shape.blocks();
  TileBits& plane = memory.plane(bit, blocks);
  TileBits made;
  const Bits bits = set_random(made, shape);
  functional::each_bit(blocks, [&](unsigned block) { plane.set_word(block, made.word(block, shape), shape); });
  bits.each([&](std::uint32_t x, std::uint32_t y) {
    if (is_in(blocks, x, y)) slow.bit(bit).set(x, y, bits.at(x, y));
  });
}

void check_read(const Memory& memory, SlowMemory& slow, unsigned bit, const TileShape& shape) {
  const std::uint64_t blocks = any_word() & shape.blocks();
  TileBits copy;
  set_random(copy, shape);
  const Bits read = bits_of(memory.read(bit, blocks, copy), shape);
  read.each([&](std::uint32_t x, std::uint32_t y) {
    if (is_in(blocks, x, y)) RC_ASSERT(read.at(x, y) == slow.bit(bit).at(x, y));
  });
}

void do_any(Memory& memory, SlowMemory& slow, const TileShape& shape) {
  const unsigned bit = any_bit();
  switch (between(0, 10)) {
    case 0:
      memory.clear();
      slow = SlowMemory(shape);
      break;
    case 1:
    case 2: slow.bit(bit) = set_random(memory.plane(bit), shape); break;
    case 3: RC_ASSERT(bits_of(memory.plane(bit), shape) == slow.bit(bit)); break;
    case 4: check_read(memory, slow, bit, shape); break;
    case 5: static_cast<void>(memory.plane(bit)); break;
    case 6: write_plane(memory, slow, bit, shape); break;
    default: write_lanes(memory, slow, any_field(), shape);
  }
}

}  // namespace

TEST_CASE("a tile's memory holds the written values in any sequence of representations") {
  CHECK(rc::check([] {
    const TileShape shape = any_shape();
    Memory memory(shape, memory_bits);
    SlowMemory slow(shape);
    const int steps = between(1, 16);
    for (int i = 0; i < steps; ++i) do_any(memory, slow, shape);
    const std::size_t stride = shape.width() + between(0U, 3U);
    std::vector<std::uint32_t> values(stride * shape.height(), 0xdeadbeefU);
    for (const Field field : {Field{0, 20}, Field{8, 32}, Field{39, 1}, any_field()}) {
      memory.values(field, values.data(), stride);
      for (std::uint32_t y = 0; y < shape.height(); ++y)
        for (std::uint32_t x = 0; x < shape.width(); ++x) {
          RC_ASSERT(values[y * stride + x] == slow.value(field, x, y));
          RC_ASSERT(memory.value(field, x, y) == slow.value(field, x, y));
        }
    }
  }));
}

TEST_CASE("a field switches between planes and lanes as it is used") {
  Memory memory({64, 3}, memory_bits);
  CHECK(memory.is_in_planes({0, 20}));
  memory.lanes({4, 8});
  CHECK_FALSE(memory.is_in_planes({0, 20}));
  CHECK(memory.is_in_planes({0, 4}));
  CHECK(memory.is_in_planes({12, 8}));
  TileBits copy;
  memory.read(5, ~std::uint64_t{0}, copy);
  CHECK_FALSE(memory.is_in_planes({4, 8}));
  memory.plane(5);
  CHECK(memory.is_in_planes({0, 20}));
}

TEST_CASE("the least recently used lanes of a tile's memory are evicted") {
  Memory memory({64, 64}, memory_bits);
  for (std::uint16_t base = 0; base < 33; ++base) {
    functional::Lanes& one = memory.lanes({base, 2});
    functional::each_bit(~std::uint64_t{0}, [&](unsigned block) { one.set_constant(block, base % 4U); });
    memory.lanes({static_cast<std::uint16_t>(base + 2), 5}, {1});
    CHECK(one.field == Field{base, 2});
    CHECK(memory.value({base, 2}, 63, 63) == base % 4U);
  }
}
