#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "sim/reference/reference_array.h"
#include "tests/support/quadric_judge.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace csgsim::engine;
using namespace csgsim::reference;

namespace {

using namespace isa;
using namespace test;

/// Reads a field of up to 64 bits in two halves.
std::uint64_t wide_value(const ReferenceArray& array, Field field, std::uint32_t x, std::uint32_t y) {
  const auto low = static_cast<std::uint16_t>(std::min<unsigned>(field.width, 32));
  std::uint64_t value = array.read({field.base, low}, x, y);
  if (field.width > low) {
    const Field upper{static_cast<std::uint16_t>(field.base + low), static_cast<std::uint16_t>(field.width - low)};
    value |= std::uint64_t{array.read(upper, x, y)} << low;
  }
  return value;
}

void put_wide(ReferenceArray& array, Field field, std::uint32_t x, std::uint32_t y, std::uint64_t value) {
  for (unsigned bit = 0; bit < field.width; ++bit)
    array.write({static_cast<std::uint16_t>(field.base + bit), 1}, x, y, static_cast<std::uint32_t>(value >> bit & 1U));
}

TEST_CASE("a root and its remainder equal those of integer arithmetic at every width") {
  for (std::uint16_t width = 3; width <= 61; width += 2) {
    CAPTURE(width);
    const Field field{5, width};
    const unsigned w = width / 2U;
    std::vector<std::uint64_t> values = test::extreme_squares(w);
    for (int i = 0; i < 60; ++i) values.push_back(test::mixed_bits(static_cast<std::uint64_t>(i), width));
    ReferenceArray array(isa::ArrayShape{static_cast<std::uint32_t>(values.size()), 1, 72});
    array.execute({Opcode::enable_all, {}, {}, 0, {}});
    for (std::uint32_t x = 0; x < values.size(); ++x) put_wide(array, field, x, 0, values[x]);
    array.execute({Opcode::root, {field}, {}, 0, {}});
    for (std::uint32_t x = 0; x < values.size(); ++x) {
      CAPTURE(values[x]);
      CHECK(wide_value(array, field, x, 0) == test::root_field(values[x], w));
      CHECK(array.read({0, 5}, x, 0) == 0U);
      CHECK(array.read({static_cast<std::uint16_t>(5 + width), 1}, x, 0) == 0U);
    }
  }
}

TEST_CASE("a disabled pixel keeps its field while others take the root") {
  ReferenceArray array(isa::ArrayShape{2, 1, 9});
  for (std::uint32_t x = 0; x < 2; ++x) array.write({0, 9}, x, 0, 200);
  array.write_enable(1, 0, true);
  array.execute({Opcode::root, {Field{0, 9}}, {}, 0, {}});
  CHECK(array.read({0, 9}, 0, 0) == 200U);
  // 14 * 14 = 196; 200 - 15 * 15 = -25, which is 7 in 5 bits.
  CHECK(array.read({0, 9}, 1, 0) == (14U << 5U | 7U));
}

TEST_CASE("squares add only to the sum of the next instruction") {
  CHECK(rc::check([] {
    const Quadratic sum = test::any_quadratic({9, 7, 0});
    const Field field{3, static_cast<std::uint16_t>(sum.linear.width - sum.linear.shift - 1)};
    ReferenceArray array(isa::ArrayShape{9, 7, 72});
    const auto load = [&] {
      array.execute({Opcode::enable_all, {}, {}, 0, {}});
      array.execute({Opcode::load_linear, {field}, sum.linear, 0, {}});
    };
    array.execute({Opcode::squares, {}, sum.squares, 0, {}});
    RC_ASSERT(array.overflows() == 0U);
    array.execute({Opcode::enable_all, {}, {}, 0, {}});
    array.execute({Opcode::squares, {}, sum.squares, 0, {}});
    array.execute({Opcode::load_linear, {field}, sum.linear, 0, {}});
    std::uint64_t overflows = 0;
    for (std::uint32_t y = 0; y < 7; ++y) {
      for (std::uint32_t x = 0; x < 9; ++x) {
        const std::int64_t f = sum.f(x, y);
        RC_ASSERT(wide_value(array, field, x, y) == below_bits(f, field.width));
        RC_ASSERT(array.is_enabled(x, y) == (f >= 0 && f >> field.width == 0));
        if (!sum.fits(x, y)) ++overflows;
      }
    }
    RC_ASSERT(array.overflows() == overflows);
    load();
    const Quadratic alone{{}, sum.linear};
    for (std::uint32_t y = 0; y < 7; ++y)
      for (std::uint32_t x = 0; x < 9; ++x)
        RC_ASSERT(wide_value(array, field, x, y) == below_bits(alone.f(x, y), field.width));
  }));
}

TEST_CASE("F is added to or subtracted from a field modulo 2^width and E is unchanged") {
  CHECK(rc::check([] {
    const Quadratic sum = test::any_quadratic({5, 3, 0});
    const auto width =
        static_cast<std::uint16_t>(*rc::gen::inRange<unsigned>(1, sum.linear.width - sum.linear.shift + 0U));
    const Field field{0, width};
    for (const Opcode opcode : {Opcode::linear_plus, Opcode::linear_minus}) {
      ReferenceArray array(isa::ArrayShape{5, 3, 64});
      array.execute({Opcode::enable_all, {}, {}, 0, {}});
      array.write_enable(2, 1, false);
      const auto before = [&](std::uint32_t x, std::uint32_t y) { return test::mixed_bits(x + 5U * y, width); };
      for (std::uint32_t y = 0; y < 3; ++y)
        for (std::uint32_t x = 0; x < 5; ++x) put_wide(array, field, x, y, before(x, y));
      array.execute({Opcode::squares, {}, sum.squares, 0, {}});
      array.execute({opcode, {field}, sum.linear, 0, {}});
      for (std::uint32_t y = 0; y < 3; ++y) {
        for (std::uint32_t x = 0; x < 5; ++x) {
          const bool enabled = x != 2 || y != 1;
          const auto t = static_cast<std::int64_t>(before(x, y));
          const std::int64_t result = opcode == Opcode::linear_plus ? sum.f(x, y) + t : sum.f(x, y) - t;
          RC_ASSERT(wide_value(array, field, x, y) == (enabled ? below_bits(result, width) : before(x, y)));
          RC_ASSERT(array.is_enabled(x, y) == enabled);
        }
      }
    }
  }));
}

}  // namespace
