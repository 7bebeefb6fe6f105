#include <rapidcheck.h>

#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/isa/opcodes.h"
#include "tests/support/plain_array.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

using array::ArrayStep;
using array::PixelArray;
using array::StreamBit;
using test::PlainArray;

constexpr std::uint32_t memory_bits = 24;

/// An array with deferred steps, and a reference that executes every step at once.
struct Pair {
  array::PlaneShape shape;
  unsigned alu_bits;
  PixelArray deferred;
  PlainArray plain;
  StreamBit tree{};

  Pair(array::PlaneShape s, unsigned alu)
      : shape(s), alu_bits(alu), deferred({s.width, s.height, memory_bits}, alu), plain(s, memory_bits, alu) {
    deferred.reset(s.width, s.height);
    plain.select_pixels(s.width, s.height);
  }

  void step(const ArrayStep& step) {
    deferred.step(step, tree);
    plain.step(step, tree);
  }
};

void check_registers(const Pair& pair) {
  for (std::uint32_t y = 0; y < pair.shape.height; ++y) {
    for (std::uint32_t x = 0; x < pair.shape.width; ++x) {
      const array::PixelProbe probe = pair.deferred.probe(x, y, pair.tree);
      const PlainArray::Pixel& pixel = pair.plain.at(x, y);
      RC_ASSERT(probe.enable == pixel.enable);
      RC_ASSERT(probe.carry == pixel.carry);
      RC_ASSERT(probe.flag == pixel.flag);
      for (unsigned bit = 0; bit < pair.alu_bits; ++bit)
        RC_ASSERT((probe.latch >> bit & 1U) == (pixel.latch[bit] ? 1U : 0U));
    }
  }
}

void check_enable(const Pair& pair) {
  std::uint64_t count = 0;
  for (std::uint32_t y = 0; y < pair.shape.height; ++y)
    for (std::uint32_t x = 0; x < pair.shape.width; ++x) count += pair.plain.at(x, y).enable ? 1U : 0U;
  RC_ASSERT(pair.deferred.any_enabled() == (count > 0));
  for (std::uint32_t y = 0; y < pair.shape.height; ++y)
    for (std::uint32_t x = 0; x < pair.shape.width; ++x)
      RC_ASSERT(array::bit_of(pair.deferred.enable(), pair.shape, x, y) == pair.plain.at(x, y).enable);
}

void check_memory(const Pair& pair, std::uint32_t address) {
  const array::Words plane = pair.deferred.memory(address);
  array::Words row(pair.shape.row_words());
  for (std::uint32_t y = 0; y < pair.shape.height; ++y) {
    pair.deferred.read_row(address, y, row);
    for (std::uint32_t x = 0; x < pair.shape.width; ++x) {
      const bool expected = pair.plain.at(x, y).memory[address];
      RC_ASSERT(array::bit_of(plane, pair.shape, x, y) == expected);
      RC_ASSERT(((row[x / 64] >> (x % 64) & 1U) != 0) == expected);
      RC_ASSERT(pair.deferred.memory_bit(address, x, y) == expected);
    }
  }
}

void check_field(const Pair& pair) {
  const auto width = *rc::gen::inRange<std::uint16_t>(1, 9);
  const isa::Field field{*rc::gen::inRange<std::uint16_t>(0, memory_bits - 8), width};
  const std::uint32_t columns = *rc::gen::inRange(1U, pair.shape.width + 1);
  std::vector<std::uint32_t> values(std::size_t{columns} * pair.shape.height);
  pair.deferred.read_field(field, columns, pair.shape.height, values);
  for (std::uint32_t y = 0; y < pair.shape.height; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      for (std::uint32_t bit = 0; bit < field.width; ++bit)
        RC_ASSERT((values[std::size_t{y} * columns + x] >> bit & 1U) ==
                  (pair.plain.at(x, y).memory[field.base + bit] ? 1U : 0U));
    }
  }
}

/// Checks one of the views of the array, or all of them.
void check_any_view(const Pair& pair) {
  switch (*rc::gen::inRange(0, 5)) {
    case 0: return check_registers(pair);
    case 1: return check_enable(pair);
    case 2: return check_memory(pair, *rc::gen::inRange(0U, memory_bits));
    case 3: return check_field(pair);
    default: break;
  }
  check_registers(pair);
  check_enable(pair);
  for (std::uint32_t address = 0; address < memory_bits; ++address) check_memory(pair, address);
}

std::uint64_t up_to(std::uint64_t value, array::Token token) {
  return value & array::low_bits(static_cast<std::size_t>(token.bit) + token.bits);
}

struct Squares {
  std::uint64_t xx = 0;
  std::uint64_t xy = 0;
  std::uint64_t yy = 0;
};

Squares any_squares() {
  const auto any = [] {
    return *rc::gen::element<std::uint64_t>(0, 1, ~std::uint64_t{0}, 12345) << *rc::gen::inRange(0U, 20U);
  };
  return *rc::gen::inRange(0, 3) == 0 ? Squares{any(), any(), any()} : Squares{};
}

/// Executes the instruction's steps and checks the array after none, a few, or all of its clocks.
void execute(Pair& pair, const isa::Instruction& instruction, array::Sequencer& sequencer) {
  const int checks_per_8_clocks = *rc::gen::weightedElement<int>({{6, 0}, {2, 1}, {1, 8}});
  const auto a = static_cast<std::uint64_t>(instruction.linear.a);
  const auto b = static_cast<std::uint64_t>(instruction.linear.b);
  const auto c = static_cast<std::uint64_t>(instruction.linear.c);
  const Squares squares = any_squares();
  sequencer.begin(instruction);
  while (sequencer.busy()) {
    const array::BitStep step = sequencer.issue();
    const array::Token token = step.root.token;
    // A coefficient, as in the trees, holds no more bits than have arrived.
    if (token.active())
      pair.tree = {token,
                   up_to(a, token),
                   up_to(b, token),
                   up_to(c, token),
                   up_to(squares.xx, token),
                   up_to(squares.xy, token),
                   up_to(squares.yy, token)};
    pair.step(step.pixels);
    if (checks_per_8_clocks > 0 && *rc::gen::inRange(0, 8) < checks_per_8_clocks) check_any_view(pair);
  }
}

/// Random step; it need not belong to any instruction.
ArrayStep any_step(unsigned alu_bits) {
  const auto bits = *rc::gen::inRange(1U, std::min(alu_bits, 8U) + 1);
  const auto address = rc::gen::inRange<std::uint16_t>(0, memory_bits - 8);
  return {.function = static_cast<array::AluFunction>(*rc::gen::inRange<std::size_t>(0, std::size(array::alu_table))),
          .source = *rc::gen::element(array::OperandSource::latch, array::OperandSource::memory),
          .x = *address,
          .y = *address,
          .write = *address,
          .bits = static_cast<std::uint16_t>(bits),
          .constant = *rc::gen::arbitrary<std::uint32_t>()};
}

/// Enables few pixels or none, so that whole blocks have no work: those whose column has the given bit.
void enable_few(Pair& pair) {
  const auto bit = *rc::gen::inRange<std::int16_t>(3, 12);
  pair.tree = {
      .token = {bit}, .a = *rc::gen::element<std::uint64_t>(0, 1), .b = *rc::gen::inRange<std::uint64_t>(0, 600)};
  pair.step({.function = array::AluFunction::enable_all});
  pair.step({.function = array::AluFunction::enable_and});
}

void do_any_change(Pair& pair, array::Sequencer& sequencer) {
  switch (*rc::gen::weightedElement<int>({{12, 0}, {3, 1}, {2, 2}, {1, 3}, {1, 4}})) {
    case 0:
      return execute(pair,
                     *test::arbitrary_instruction({pair.shape.width, pair.shape.height, memory_bits}, memory_bits, 3),
                     sequencer);
    case 1: return enable_few(pair);
    case 2: return pair.step(any_step(pair.alu_bits));
    case 3: {
      const auto address = *rc::gen::inRange(0U, memory_bits - 4);
      pair.deferred.clear_memory(address, 4);
      return pair.plain.clear_memory(address, 4);
    }
    default: {
      const auto width = *rc::gen::inRange(1U, pair.shape.width + 1);
      const auto height = *rc::gen::inRange(1U, pair.shape.height + 1);
      pair.deferred.select_pixels(width, height);
      return pair.plain.select_pixels(width, height);
    }
  }
}

void check(array::PlaneShape shape) {
  CAPTURE(shape.width);
  CAPTURE(shape.height);
  CHECK(rc::check([shape] {
    const auto alu_bits = *rc::gen::element(1U, 1U, 3U, 8U, 32U);
    const auto tree_bits = *rc::gen::inRange(1U, alu_bits + 1);
    array::Sequencer sequencer(*rc::gen::inRange(1U, 3U), alu_bits, tree_bits);
    Pair pair(shape, alu_bits);
    const int acts = *rc::gen::inRange(5, 60);
    for (int i = 0; i < acts; ++i) do_any_change(pair, sequencer);
    check_registers(pair);
    check_enable(pair);
    for (std::uint32_t address = 0; address < memory_bits; ++address) check_memory(pair, address);
  }));
}

}  // namespace

TEST_CASE("reads of an array between deferred steps match immediate execution") {
  for (const array::PlaneShape shape : {array::PlaneShape{1, 1}, {5, 9}, {64, 20}, {130, 9}, {512, 4}, {640, 3}})
    check(shape);
}

TEST_CASE("hundreds of deferred steps execute without a read and later reads see them") {
  Pair pair({512, 3}, 1);
  pair.step({.function = array::AluFunction::enable_all});
  pair.tree = {.token = {.bit = 5}, .a = 3, .b = 1};
  pair.step({.function = array::AluFunction::store_x, .write = 2});
  // No pixel outside the first row is enabled below.
  pair.tree = {.token = {.bit = 0}, .b = 1, .c = 1};
  pair.step({.function = array::AluFunction::enable_and});
  pair.tree = {.token = {.bit = 1}, .b = 1, .c = 2};
  pair.step({.function = array::AluFunction::enable_and});
  REQUIRE(pair.deferred.count_enabled() == 512);
  pair.step({.function = array::AluFunction::compare_from_1, .source = array::OperandSource::memory, .x = 2, .y = 3});
  for (int i = 0; i < 500; ++i) {
    pair.step({.function = array::AluFunction::latch_x, .source = array::OperandSource::memory, .x = 2});
    REQUIRE(pair.deferred.count_enabled() == 512);
  }
  pair.step({.function = array::AluFunction::store_not_x, .source = array::OperandSource::latch, .write = 2});
  check_registers(pair);
  check_memory(pair, 2);
}
