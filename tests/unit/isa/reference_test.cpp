#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "sim/reference/reference_array.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace csgsim::reference;

namespace {

using namespace isa;

using Values = std::vector<std::uint32_t>;
using Bits = std::vector<int>;

constexpr Field t{0, 4};   // target of most cases
constexpr Field s{4, 4};   // source
constexpr Field t1{8, 1};  // single bits
constexpr Field s1{9, 1};
constexpr Field r1{10, 1};

/// A row of enabled pixels with 12 memory bits.
ReferenceArray row(std::uint32_t width) {
  ReferenceArray array(isa::ArrayShape{width, 1, 12});
  array.execute({Opcode::enable_all, {}, {}, 0, {}});
  return array;
}

void set(ReferenceArray& array, Field field, const Values& values) {
  for (std::uint32_t x = 0; x < values.size(); ++x) array.write(field, x, 0, values[x]);
}

void enable(ReferenceArray& array, const Bits& bits) {
  for (std::uint32_t x = 0; x < bits.size(); ++x) array.write_enable(x, 0, bits[x] != 0);
}

Values values(const ReferenceArray& array, Field field) {
  Values all(static_cast<std::size_t>(array.region().width) * array.region().height);
  array.read_field(field, all);
  return all;
}

Bits enabled(const ReferenceArray& array) {
  Bits bits;
  for (std::uint32_t y = 0; y < array.region().height; ++y)
    for (std::uint32_t x = 0; x < array.region().width; ++x) bits.push_back(array.is_enabled(x, y) ? 1 : 0);
  return bits;
}

Instruction on_fields(Opcode opcode, Field first = {}, Field second = {}, Field third = {}) {
  return {opcode, {first, second, third}, {}, 0, {}};
}

Instruction on_linear(Opcode opcode, Field field, Linear linear) { return {opcode, {field}, linear, 0, {}}; }

/// E after the instruction for E and s1 before it, from pixel 0: 0 0, 0 1, 1 0, 1 1.
Bits enable_table(Opcode opcode, Field operand = s1) {
  ReferenceArray array = row(4);
  set(array, s1, {0, 1, 0, 1});
  enable(array, {0, 0, 1, 1});
  array.execute(on_fields(opcode, operand));
  CHECK(values(array, s1) == Values{0, 1, 0, 1});
  return enabled(array);
}

/// t1 after the instruction for s1 and r1 before it, from pixel 0: 0 0, 0 1, 1 0, 1 1; then a disabled pixel.
Values bit_table(Opcode opcode, Field second = r1) {
  ReferenceArray array = row(5);
  set(array, s1, {0, 0, 1, 1, 1});
  set(array, r1, {0, 1, 0, 1, 0});
  set(array, t1, {1, 1, 1, 1, 1});
  enable(array, {1, 1, 1, 1, 0});
  array.execute(on_fields(opcode, t1, s1, second));
  CHECK(values(array, s1) == Values{0, 0, 1, 1, 1});
  CHECK(enabled(array) == Bits{1, 1, 1, 1, 0});
  return values(array, t1);
}

TEST_CASE("pixel memory and enable bits start at 0") {
  const ReferenceArray array(isa::ArrayShape{2, 3, 12});
  CHECK(values(array, {0, 12}) == Values{0, 0, 0, 0, 0, 0});
  CHECK(enabled(array) == Bits{0, 0, 0, 0, 0, 0});
}

TEST_CASE("enable_all and enable_invert act at every pixel") {
  CHECK(enable_table(Opcode::enable_all, {}) == Bits{1, 1, 1, 1});
  CHECK(enable_table(Opcode::enable_invert, {}) == Bits{1, 1, 0, 0});
}

TEST_CASE("enable instructions combine E with a bit") {
  CHECK(enable_table(Opcode::enable_load) == Bits{0, 1, 0, 1});
  CHECK(enable_table(Opcode::enable_and) == Bits{0, 0, 0, 1});
  CHECK(enable_table(Opcode::enable_and_not) == Bits{0, 0, 1, 0});
  CHECK(enable_table(Opcode::enable_or) == Bits{0, 1, 1, 1});
  CHECK(enable_table(Opcode::enable_xor) == Bits{0, 1, 1, 0});
}

TEST_CASE("enable_store writes E at enabled and disabled pixels") {
  ReferenceArray array = row(2);
  set(array, t1, {0, 1});
  enable(array, {1, 0});
  array.execute(on_fields(Opcode::enable_store, t1));
  CHECK(values(array, t1) == Values{1, 0});
  CHECK(enabled(array) == Bits{1, 0});
}

TEST_CASE("edge tests keep the pixels on one side and 0 is not negative") {
  // 2x - 4 is -4, -2, 0, 2 at x = 0, 1, 2, 3.
  ReferenceArray array = row(4);
  array.execute(on_linear(Opcode::edge_not_negative, {}, {2, 0, -4, 4, 0}));
  CHECK(enabled(array) == Bits{0, 0, 1, 1});

  array = row(4);
  array.execute(on_linear(Opcode::edge_negative, {}, {2, 0, -4, 4, 0}));
  CHECK(enabled(array) == Bits{1, 1, 0, 0});
}

TEST_CASE("edge tests never enable a pixel") {
  ReferenceArray array = row(2);
  enable(array, {0, 1});
  array.execute(on_linear(Opcode::edge_not_negative, {}, {0, 0, 1, 2, 0}));
  CHECK(enabled(array) == Bits{0, 1});
}

TEST_CASE("x is the column and y the row within the segment") {
  ReferenceArray array(isa::Region{5, 7, 3, 2}, 12);
  array.execute({Opcode::enable_all, {}, {}, 0, {}});
  array.execute(on_linear(Opcode::load_linear, {0, 8}, {1, 10, 100, 9, 0}));
  CHECK(values(array, {0, 8}) == Values{100, 101, 102, 110, 111, 112});
}

TEST_CASE("F is shifted rounding down") {
  // x - 3 is -3 ... 3; halved rounding down: -2, -1, -1, 0, 0, 1, 1. Plus 2: 0, 1, 1, 2, 2, 3, 3.
  ReferenceArray array = row(7);
  array.execute(on_linear(Opcode::load_linear, t, {1, 0, -3 + 4, 8, 1}));
  CHECK(values(array, t) == Values{0, 1, 1, 2, 2, 3, 3});

  // (x - 3) >> 1 is negative for x = 0, 1, 2, because -1 >> 1 is -1.
  array = row(7);
  array.execute(on_linear(Opcode::edge_negative, {}, {1, 0, -3, 4, 1}));
  CHECK(enabled(array) == Bits{1, 1, 1, 0, 0, 0, 0});
}

TEST_CASE("F loses the high bits that exceed its width") {
  // 3 bits hold -4 to 3: 2, 3, 4, 5 become 2, 3, -4, -3.
  ReferenceArray array = row(4);
  array.execute(on_linear(Opcode::edge_negative, {}, {1, 0, 2, 3, 0}));
  CHECK(enabled(array) == Bits{0, 0, 1, 1});
  CHECK(array.overflows() == 2);
}

TEST_CASE("overflows of F count only at enabled pixels") {
  ReferenceArray array = row(4);
  enable(array, {1, 1, 1, 0});
  array.execute(on_linear(Opcode::edge_negative, {}, {1, 0, 2, 3, 0}));
  CHECK(array.overflows() == 1);
  array.execute({Opcode::enable_all, {}, {}, 0, {}});
  array.execute(on_linear(Opcode::edge_negative, {}, {0, 0, -5, 3, 0}));
  CHECK(array.overflows() == 5);
  array.execute({Opcode::enable_all, {}, {}, 0, {}});
  array.execute(on_linear(Opcode::edge_negative, {}, {0, 0, -4, 3, 0}));
  CHECK(array.overflows() == 5);
}

TEST_CASE("a negative F is less than every field") {
  // x - 1 is -1, 0, 1, 2, 3, compared with 0, 0, 2, 2, 2.
  const auto compared = [](Opcode opcode) {
    ReferenceArray array = row(5);
    set(array, s, {0, 0, 2, 2, 2});
    array.execute(on_linear(opcode, s, {1, 0, -1, 5, 0}));
    CHECK(values(array, s) == Values{0, 0, 2, 2, 2});
    return enabled(array);
  };
  CHECK(compared(Opcode::linear_ge) == Bits{0, 1, 0, 1, 1});
  CHECK(compared(Opcode::linear_gt) == Bits{0, 0, 0, 0, 1});
  CHECK(compared(Opcode::linear_le) == Bits{1, 1, 1, 1, 0});
  CHECK(compared(Opcode::linear_lt) == Bits{1, 0, 1, 0, 0});
  CHECK(compared(Opcode::linear_eq) == Bits{0, 1, 0, 1, 0});
}

TEST_CASE("comparisons never enable a pixel") {
  for (const Opcode opcode :
       {Opcode::linear_ge, Opcode::linear_gt, Opcode::linear_le, Opcode::linear_lt, Opcode::linear_eq}) {
    ReferenceArray array = row(3);
    set(array, s, {4, 5, 6});
    enable(array, {0, 0, 0});
    array.execute(on_linear(opcode, s, {0, 0, 5, 5, 0}));
    CHECK(enabled(array) == Bits{0, 0, 0});
  }
}

TEST_CASE("F beyond the field's range is compared by its full value") {
  // The low bits of 19 are 3, but it is greater than 5.
  ReferenceArray array = row(1);
  set(array, s, {5});
  array.execute(on_linear(Opcode::linear_gt, s, {0, 0, 19, 6, 0}));
  CHECK(enabled(array) == Bits{1});
}

TEST_CASE("load_linear writes F where enabled and disables where it does not fit") {
  // 8x - 8 is -8, 0, 8, 16; 4 bits hold 0 to 15. The low bits of -8 are 8, of 16 they are 0.
  ReferenceArray array = row(5);
  set(array, t, {7, 7, 7, 7, 7});
  enable(array, {1, 1, 1, 1, 0});
  array.execute(on_linear(Opcode::load_linear, t, {8, 0, -8, 7, 0}));
  CHECK(values(array, t) == Values{8, 0, 8, 0, 7});
  CHECK(enabled(array) == Bits{0, 1, 1, 0, 0});
}

TEST_CASE("keep_max writes where F is greater and disables where that does not fit") {
  // 6x - 4 is -4, 2, 8, 14, 20, compared with 5, 2, 5, 15, 5; the last pixel is disabled from the start.
  ReferenceArray array = row(6);
  set(array, t, {5, 2, 5, 15, 5, 5});
  enable(array, {1, 1, 1, 1, 1, 0});
  array.execute(on_linear(Opcode::keep_max, t, {6, 0, -4, 8, 0}));
  CHECK(values(array, t) == Values{5, 2, 8, 15, 4, 5});
  CHECK(enabled(array) == Bits{1, 1, 1, 1, 0, 0});
}

TEST_CASE("keep_min writes where F is less and disables where that does not fit") {
  // 6x - 4 is -4, 2, 8, 14, 20, compared with 5, 2, 9, 15, 5; the low bits of -4 are 12.
  ReferenceArray array = row(6);
  set(array, t, {5, 2, 9, 15, 5, 15});
  enable(array, {1, 1, 1, 1, 1, 0});
  array.execute(on_linear(Opcode::keep_min, t, {6, 0, -4, 8, 0}));
  CHECK(values(array, t) == Values{12, 2, 8, 14, 5, 15});
  CHECK(enabled(array) == Bits{0, 1, 1, 1, 1, 0});
}

TEST_CASE("load_linear loads the widest linear expression into a wide field") {
  // 2^61 - 1 over 30 fraction bits is 2^31 - 1, rounded down; its negative is -2^31.
  constexpr std::int64_t most = (std::int64_t{1} << 61U) - 1;
  ReferenceArray array(isa::ArrayShape{2, 1, 32});
  array.execute({Opcode::enable_all, {}, {}, 0, {}});
  array.execute(on_linear(Opcode::load_linear, {0, 31}, {-2 * most, 0, most, 62, 30}));
  CHECK(values(array, {0, 31}) == Values{0x7fffffffU, 0});
  CHECK(enabled(array) == Bits{1, 0});
  CHECK(array.overflows() == 0);
}

TEST_CASE("set_constant and copy write only where enabled and leave other bits unchanged") {
  ReferenceArray array = row(2);
  set(array, {0, 12}, {0xfff, 0xfff});
  enable(array, {1, 0});
  array.execute({Opcode::set_constant, {t}, {}, 9, {}});
  CHECK(values(array, {0, 12}) == Values{0xff9, 0xfff});
  array.execute(on_fields(Opcode::copy, s, t));
  CHECK(values(array, {0, 12}) == Values{0xf99, 0xfff});
  CHECK(enabled(array) == Bits{1, 0});
}

TEST_CASE("fields are compared as unsigned numbers") {
  const auto compared = [](Opcode opcode) {
    ReferenceArray array = row(4);
    set(array, t, {3, 7, 15, 2});
    set(array, s, {3, 8, 1, 9});
    enable(array, {1, 1, 1, 0});
    array.execute(on_fields(opcode, t, s));
    return enabled(array);
  };
  CHECK(compared(Opcode::field_lt) == Bits{0, 1, 0, 0});
  CHECK(compared(Opcode::field_le) == Bits{1, 1, 0, 0});
  CHECK(compared(Opcode::field_eq) == Bits{1, 0, 0, 0});
}

TEST_CASE("bit instructions write only where enabled") {
  CHECK(bit_table(Opcode::bit_and) == Values{0, 0, 0, 1, 1});
  CHECK(bit_table(Opcode::bit_or) == Values{0, 1, 1, 1, 1});
  CHECK(bit_table(Opcode::bit_xor) == Values{0, 1, 1, 0, 1});
  CHECK(bit_table(Opcode::bit_and_not) == Values{0, 0, 1, 0, 1});
  CHECK(bit_table(Opcode::bit_not, {}) == Values{1, 1, 0, 0, 1});
}

TEST_CASE("a bit instruction may write one of its sources") {
  ReferenceArray array = row(2);
  set(array, s1, {0, 1});
  array.execute(on_fields(Opcode::bit_not, s1, s1));
  CHECK(values(array, s1) == Values{1, 0});
  array.execute(on_fields(Opcode::bit_xor, s1, s1, s1));
  CHECK(values(array, s1) == Values{0, 0});
}

TEST_CASE("bit instructions act bitwise on fields and skip disabled pixels") {
  const auto bitwise_result = [](Opcode opcode) {
    ReferenceArray array = row(2);
    set(array, t, {0b1001, 0b1001});
    set(array, s, {0b0011, 0b0011});
    set(array, {8, 4}, {0b0101, 0b0101});
    enable(array, {1, 0});
    array.execute(on_fields(opcode, t, s, opcode == Opcode::bit_not ? Field{} : Field{8, 4}));
    CHECK(values(array, s) == Values{0b0011, 0b0011});
    return values(array, t);
  };
  CHECK(bitwise_result(Opcode::bit_and) == Values{0b0001, 0b1001});
  CHECK(bitwise_result(Opcode::bit_or) == Values{0b0111, 0b1001});
  CHECK(bitwise_result(Opcode::bit_xor) == Values{0b0110, 0b1001});
  CHECK(bitwise_result(Opcode::bit_and_not) == Values{0b0010, 0b1001});
  CHECK(bitwise_result(Opcode::bit_not) == Values{0b1100, 0b1001});
}

TEST_CASE("xor_constant inverts the target where the constant is 1") {
  ReferenceArray array = row(3);
  set(array, t, {0b0000, 0b1010, 0b1010});
  set(array, s, {15, 0, 15});
  enable(array, {1, 1, 0});
  array.execute({Opcode::xor_constant, {t}, {}, 0b0110, {}});
  CHECK(values(array, t) == Values{0b0110, 0b1100, 0b1010});
  CHECK(values(array, s) == Values{15, 0, 15});
}

TEST_CASE("add writes only where enabled and drops the carry out of the target's top bit") {
  ReferenceArray array = row(5);
  set(array, t, {0, 9, 15, 15, 9});
  set(array, s, {0, 5, 1, 15, 5});
  enable(array, {1, 1, 1, 1, 0});
  array.execute(on_fields(Opcode::add, t, s));
  CHECK(values(array, t) == Values{0, 14, 0, 14, 9});
  CHECK(values(array, s) == Values{0, 5, 1, 15, 5});
  CHECK(enabled(array) == Bits{1, 1, 1, 1, 0});
}

TEST_CASE("add extends a narrower source with zeros and propagates the carry") {
  ReferenceArray array = row(4);
  set(array, t, {0b0011, 0b0111, 0b1100, 0b1101});
  set(array, s1, {1, 1, 0, 1});
  array.execute(on_fields(Opcode::add, t, s1));
  CHECK(values(array, t) == Values{0b0100, 0b1000, 0b1100, 0b1110});
  CHECK(values(array, s) == Values{0, 0, 0, 0});
}

TEST_CASE("random fields add like integers modulo the target's range") {
  CHECK(rc::check([] {
    const auto wide = *rc::gen::inRange<std::uint16_t>(1, 33);
    const auto narrow = *rc::gen::inRange<std::uint16_t>(1, static_cast<std::uint16_t>(wide + 1));
    const Field target{0, wide};
    const Field source{wide, narrow};
    const auto number = [](unsigned width) {
      return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << width));
    };
    const std::uint64_t first = number(wide);
    const std::uint64_t second = number(narrow);
    ReferenceArray array(isa::ArrayShape{1, 1, 64});
    array.execute({Opcode::enable_all, {}, {}, 0, {}});
    array.write(target, 0, 0, static_cast<std::uint32_t>(first));
    array.write(source, 0, 0, static_cast<std::uint32_t>(second));
    array.execute(on_fields(Opcode::add, target, source));
    RC_ASSERT(array.read(target, 0, 0) == (first + second) % (std::uint64_t{1} << wide));
    RC_ASSERT(array.read(source, 0, 0) == second);
  }));
}

TEST_CASE("a stripe is as wide as the gap and repeats without overflow") {
  // x + 2 mod 8 is 2 to 7, 0, 1, 2 ...: at least 4 at x = 2 to 5 and 10 to 13.
  ReferenceArray array = row(15);
  array.execute(on_linear(Opcode::stripe, {}, {1, 0, 2, 3, 0}));
  CHECK(enabled(array) == Bits{0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 0});
  CHECK(array.overflows() == 0);
}

TEST_CASE("stripes continue at negative sums for any shift") {
  // x - 5 mod 4 starts at x = 0 with 3, 0, 1, 2, 3, 0, 1.
  for (const std::uint16_t shift : {std::uint16_t{0}, std::uint16_t{1}}) {
    ReferenceArray array = row(7);
    array.execute(on_linear(Opcode::stripe, {}, {1, 0, -5, 2, shift}));
    CHECK(enabled(array) == Bits{1, 0, 0, 1, 1, 0, 0});
  }
}

TEST_CASE("stripes only clear E") {
  ReferenceArray array = row(4);
  enable(array, {0, 1, 0, 1});
  array.execute(on_linear(Opcode::stripe, {}, {0, 0, 1, 1, 0}));
  CHECK(enabled(array) == Bits{0, 1, 0, 1});
}

TEST_CASE("stripes are one bit of A x + B y + C in wide arithmetic") {
  CHECK(rc::check([] {
    const auto below = [](std::int64_t end) {
      return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(-end + 1, end));
    };
    const Linear linear{below(1LL << 56), below(1LL << 56), below(1LL << 60), *rc::gen::inRange<std::uint16_t>(1, 63),
                        0};
    ReferenceArray array(isa::ArrayShape{7, 5, 1});
    array.execute({Opcode::enable_all, {}, {}, 0, {}});
    array.execute(on_linear(Opcode::stripe, {}, linear));
    for (std::uint32_t y = 0; y < 5; ++y) {
      for (std::uint32_t x = 0; x < 7; ++x) {
        const std::int64_t sum = linear.a * x + linear.b * y + linear.c;  // below 2^62
        RC_ASSERT(array.is_enabled(x, y) == ((sum >> (linear.width - 1U) & 1) == 1));
      }
    }
    RC_ASSERT(array.overflows() == 0U);
  }));
}

TEST_CASE("global_or changes no pixel") {
  ReferenceArray array = row(2);
  enable(array, {0, 1});
  set(array, t, {3, 4});
  array.execute(on_fields(Opcode::global_or));
  CHECK(values(array, t) == Values{3, 4});
  CHECK(enabled(array) == Bits{0, 1});
}

TEST_CASE("an array may have a single pixel") {
  ReferenceArray array(isa::ArrayShape{1, 1, 1});
  array.execute({Opcode::enable_all, {}, {}, 0, {}});
  array.execute(on_linear(Opcode::load_linear, {0, 1}, {100, 100, 1, 2, 0}));
  CHECK(values(array, {0, 1}) == Values{1});
  CHECK(array.enabled_pixels() == 1);
}

TEST_CASE("enable bits are read in 64-bit words with padded rows") {
  ReferenceArray array(isa::ArrayShape{65, 2, 1});
  array.write_enable(0, 0, true);
  array.write_enable(64, 0, true);
  array.write_enable(63, 1, true);
  std::array<std::uint64_t, 4> words{~0ULL, ~0ULL, ~0ULL, ~0ULL};
  array.read_enable(words);
  CHECK(words == std::array<std::uint64_t, 4>{1, 1, 1ULL << 63U, 0});
  CHECK(array.enabled_pixels() == 3);
}

}  // namespace
