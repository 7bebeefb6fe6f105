#include "sim/functional/memory.h"

#include <doctest/doctest.h>

#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;
using isa::Field;
using sim::BitPlane;
using sim::Memory;

namespace {

constexpr unsigned memory_bits = 40;

/// Every bit of every pixel, one by one.
class SlowMemory {
 public:
  explicit SlowMemory(const Pixels& size) : bits_(memory_bits, size) {}

  [[nodiscard]] Pixels& bit(unsigned number) { return bits_[number]; }
  [[nodiscard]] std::uint32_t value(Field field, std::uint32_t x, std::uint32_t y) const {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < field.width; ++i) {
      if (bits_[field.base + i].at(x, y)) value |= std::uint32_t{1} << i;
    }
    return value;
  }
  void write(Field field, std::uint32_t x, std::uint32_t y, std::uint32_t value) {
    for (unsigned i = 0; i < field.width; ++i) bits_[field.base + i].set(x, y, (value >> i & 1U) != 0);
  }
  [[nodiscard]] std::vector<std::uint32_t> values(Field field) const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t y = 0; y < bits_[0].height(); ++y)
      for (std::uint32_t x = 0; x < bits_[0].width(); ++x) all.push_back(value(field, x, y));
    return all;
  }

 private:
  std::vector<Pixels> bits_;
};

/// One of few fields that overlap each other, or any.
Field any_field() {
  const auto base = between<std::uint16_t>(0, memory_bits);
  const auto width = between<std::uint16_t>(1, std::min<std::uint16_t>(32, memory_bits - base) + 1);
  return *rc::gen::element(Field{0, 20}, Field{8, 32}, Field{20, 20}, Field{0, 8}, Field{39, 1}, Field{base, width});
}

unsigned any_bit() { return *rc::gen::element(0U, 7U, 8U, 19U, 39U, between(0U, memory_bits)); }

/// Writes a value of its own at each pixel of a rectangle of the lanes.
void write_lanes(Memory& memory, SlowMemory& slow, Field field, const sim::Rect& rect) {
  sim::Lanes& lanes = memory.lanes(field);
  RC_ASSERT(lanes.field == field);
  if (rect.empty()) return;
  std::uint32_t* const first = memory.at(lanes, rect);
  const std::size_t words_per_row = (slow.bit(0).width() + 63) / 64;
  const std::uint32_t seed = static_cast<std::uint32_t>(any_word());
  for (std::uint32_t y = rect.y0; y < rect.y1; ++y) {
    for (std::uint32_t x = rect.x0; x < rect.x1; ++x) {
      const std::uint32_t value = (seed * (x + 1) + y) >> (32U - field.width);
      first[(y - rect.y0) * words_per_row * 64 + x - rect.x0 / 64 * 64] = value;
      slow.write(field, x, y, value);
    }
  }
  lanes.bounds = sim::hull(lanes.bounds, rect);
}

void check_read(const Memory& memory, SlowMemory& slow, unsigned bit, const sim::Rect& where) {
  const Pixels& expected = slow.bit(bit);
  BitPlane copy(expected.width(), expected.height());
  copy.fill(copy.whole());
  const Pixels read = pixels_of(memory.read(bit, where, copy));
  for (std::uint32_t y = where.y0; y < where.y1; ++y)
    for (std::uint32_t x = where.x0; x < where.x1; ++x) RC_ASSERT(read.at(x, y) == expected.at(x, y));
}

void do_any(Memory& memory, SlowMemory& slow, const Pixels& size) {
  const sim::Rect whole{0, 0, size.width(), size.height()};
  const unsigned bit = any_bit();
  const Field field = any_field();
  switch (between(0, 8)) {
    case 0:
      memory.clear();
      slow = SlowMemory(size);
      break;
    case 1:
    case 2: slow.bit(bit) = set_any(memory.plane(bit)); break;
    case 3: RC_ASSERT(pixels_of(memory.plane(bit)) == slow.bit(bit)); break;
    case 4: check_read(memory, slow, bit, any_rect(whole)); break;
    case 5: static_cast<void>(memory.plane(bit)); break;
    default: write_lanes(memory, slow, field, any_rect(whole));
  }
}

}  // namespace

TEST_CASE("memory holds what was written, whichever form each bit is in and was in before") {
  CHECK(rc::check([] {
    const Pixels size = any_size();
    Memory memory(size.width(), size.height(), memory_bits);
    SlowMemory slow(size);
    const int steps = between(1, 16);
    for (int i = 0; i < steps; ++i) do_any(memory, slow, size);
    std::vector<std::uint32_t> values(std::size_t{size.width()} * size.height(), 0xdeadbeefU);
    for (const Field field : {Field{0, 20}, Field{8, 32}, Field{39, 1}, any_field()}) {
      memory.values(field, values);
      RC_ASSERT(values == slow.values(field));
    }
  }));
}

TEST_CASE("a field is in planes until it is used as a number, and again when a bit of it is") {
  Memory memory(70, 3, memory_bits);
  CHECK(memory.in_planes({0, 20}));
  memory.lanes({4, 8});
  CHECK_FALSE(memory.in_planes({0, 20}));
  CHECK(memory.in_planes({0, 4}));
  CHECK(memory.in_planes({12, 8}));
  BitPlane copy(70, 3);
  memory.read(5, copy.whole(), copy);
  CHECK_FALSE(memory.in_planes({4, 8}));
  memory.plane(5);
  CHECK(memory.in_planes({0, 20}));
}
