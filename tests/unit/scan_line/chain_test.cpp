#include "hw/scan_line/chain.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "sim/reference/reference_array.h"
#include "tests/support/random_program.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using scan_line::Chain;
using scan_line::Departure;
using scan_line::Keep;
using scan_line::packet_word;
using scan_line::PacketWord;
using scan_line::RefreshPixel;
using scan_line::WordKind;

namespace {

constexpr PacketWord nothing{};
constexpr Field colour{0, 8};

/// The packet's words, in order.
std::vector<PacketWord> packet(const Instruction& instruction, std::uint16_t words, std::uint32_t word_bits,
                               bool begins_line = false) {
  std::vector<PacketWord> all;
  for (std::uint16_t number = 0; number < words; ++number) {
    all.push_back(packet_word(instruction, number, word_bits));
    all.back().begins_line = begins_line;
    all.back().last = number + 1 == words;
    all.back().keep = Keep::all;
  }
  return all;
}

PacketWord mark() {
  PacketWord word{.kind = WordKind::mark, .last = true, .keep = Keep::all};
  word.instruction.fields[0] = colour;
  return word;
}

std::uint16_t words_for(const Instruction& instruction, std::uint32_t word_bits) {
  std::uint32_t bits = std::max<std::uint32_t>(instruction.linear.width, 1);
  for (const Field& field : instruction.fields) bits = std::max<std::uint32_t>(bits, field.width);
  return static_cast<std::uint16_t>((bits + word_bits - 1) / word_bits);
}

void require_same(const scan_line::Snapshot& actual, const sim::ReferenceArray& expected, isa::ArrayShape shape) {
  for (std::uint32_t x = 0; x < shape.width; ++x) {
    RC_ASSERT((actual.enable[x / 64] >> x % 64 & 1U) == (expected.enabled(x, 0) ? 1U : 0U));
    for (std::uint32_t bit = 0; bit < shape.memory_bits; ++bit) {
      const Field field{static_cast<std::uint16_t>(bit), 1};
      RC_ASSERT(actual.read(x, field) == expected.read(field, x, 0));
    }
  }
}

}  // namespace

TEST_CASE("a packet of two words acts in cell x one clock after cell x - 1, and leaves the line after the last") {
  Chain chain(9, 8, 4);
  chain.begin(5);
  const Instruction instruction{.opcode = Opcode::edge_negative, .linear = {.a = 1, .c = 3, .width = 8}};
  const std::vector<PacketWord> words = packet(instruction, 2, 4);
  std::vector<WordKind> left;
  for (std::size_t clock = 0; clock < 8; ++clock) {
    chain.step(clock < words.size() ? words[clock] : nothing);
    left.push_back(chain.departure().kind);
  }
  std::vector<WordKind> expected(8, WordKind::none);
  expected[1 + 4] = WordKind::instruction;
  CHECK(left == expected);
  CHECK(chain.busy_cells() == 2 * 5);
}

TEST_CASE("after random packets, some many words long, every cell holds what the reference holds") {
  CHECK(rc::check([] {
    const isa::ArrayShape shape{*rc::gen::inRange(1U, 70U), 1, *rc::gen::inRange(1U, 100U)};
    const std::uint32_t word_bits = *rc::gen::inRange(1U, 65U);
    const auto instructions = *rc::gen::resize(
        20, rc::gen::container<std::vector<Instruction>>(test::arbitrary_instruction(shape, shape.memory_bits, 0)));
    Chain chain(shape.width + 3, shape.memory_bits, word_bits);
    chain.begin(shape.width);
    sim::ReferenceArray judge(shape);
    std::size_t left = 0;
    const auto look = [&] {
      const Departure& departure = chain.departure();
      if (departure.kind == WordKind::none) return;
      RC_ASSERT(departure.enabled_pixels == judge.enabled_pixels());
      judge.execute(instructions[left++]);
      require_same(*departure.snapshot, judge, shape);
    };
    for (const Instruction& instruction : instructions) {
      for (const PacketWord& word : packet(instruction, words_for(instruction, word_bits), word_bits)) {
        chain.step(word);
        look();
      }
    }
    for (std::uint32_t i = 0; i < shape.width; ++i) {
      chain.step(nothing);
      look();
    }
    RC_ASSERT(left == instructions.size());
  }));
}

TEST_CASE("the first packet of a line finds memory and enable clear") {
  Chain chain(2, 8, 8);
  chain.begin(2);
  const Instruction set{.opcode = Opcode::set_constant, .fields = {colour}, .constant = 200};
  for (const Instruction& one : {Instruction{.opcode = Opcode::enable_all}, set}) chain.step(packet(one, 1, 8)[0]);
  chain.step(packet({.opcode = Opcode::enable_invert}, 1, 8)[0]);
  CHECK(chain.cells().read(0, colour) == 200);
  chain.step(packet(set, 1, 8, true)[0]);
  CHECK(chain.cells().read(0, colour) == 0);
  CHECK_FALSE(chain.cells().enabled(0));
}

TEST_CASE("pixel x is at the refresh port in the x-th clock after that in which the shift chain took the line") {
  constexpr std::uint32_t pixels = 3;
  Chain chain(5, 8, 8);
  chain.begin(pixels);
  const Instruction ramp{.opcode = Opcode::load_linear, .fields = {colour}, .linear = {.a = 5, .c = 7, .width = 10}};
  chain.step(packet({.opcode = Opcode::enable_all}, 1, 8)[0]);
  for (const PacketWord& word : packet(ramp, 2, 8)) chain.step(word);
  chain.step(mark());
  std::vector<RefreshPixel> seen;  // from the clock after the mark's entry on
  for (std::uint32_t i = 0; i < 8; ++i) {
    seen.push_back(chain.refresh());
    chain.step(nothing);
  }
  const std::vector<RefreshPixel> expected{{}, {}, {}, {true, 7}, {true, 12}, {true, 17}, {}, {}};
  CHECK(seen == expected);
}

TEST_CASE("a mark may follow another as many clocks later as a line has pixels, and not sooner") {
  constexpr std::uint32_t pixels = 4;
  for (std::uint32_t apart = 1; apart <= pixels + 1; ++apart) {
    CAPTURE(apart);
    Chain chain(6, 8, 8);
    chain.begin(pixels);
    std::uint32_t shown = 0;
    const auto step = [&](const PacketWord& word) {
      chain.step(word);
      shown += chain.refresh().valid ? 1U : 0U;
    };
    step(mark());
    for (std::uint32_t i = 1; i < apart; ++i) step(nothing);
    if (apart < pixels) {
      CHECK_THROWS_AS(step(mark()), std::logic_error);
      continue;
    }
    CHECK_NOTHROW(step(mark()));
    for (std::uint32_t i = 0; i < 4 * pixels; ++i) step(nothing);
    CHECK(shown == 2 * pixels);
  }
}
