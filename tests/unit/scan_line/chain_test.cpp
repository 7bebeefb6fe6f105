#include "hw/scan_line/chain.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "hw/isa/opcodes.h"
#include "sim/reference/reference_array.h"
#include "tests/support/random_program.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using scan_line::CellShape;
using scan_line::Chain;
using scan_line::Departure;
using scan_line::PacketWord;
using scan_line::RefreshPixel;
using scan_line::WordKind;
using systemc::Keep;

namespace {

constexpr PacketWord nothing{};
constexpr Field colour{0, 8};

/// The packet's beats, in order.
std::vector<PacketWord> packet(const Instruction& instruction, const CellShape& shape, bool begins_line = false) {
  PacketWord first = scan_line::instruction_packet(instruction, shape);
  first.begins_line = begins_line;
  first.keep = Keep::all;
  std::vector<PacketWord> all{first};
  while (!all.back().last()) all.push_back(scan_line::next_beat(all.back(), shape));
  return all;
}

PacketWord mark() {
  PacketWord word = scan_line::mark_packet(colour, {.word_bits = 8, .ports = 1});
  word.keep = Keep::all;
  return word;
}

void require_same(const scan_line::Snapshot& actual, const reference::ReferenceArray& expected, isa::ArrayShape shape) {
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
  constexpr CellShape shape{.word_bits = 4, .ports = 1};
  Chain chain(9, 8, shape);
  chain.begin(5);
  const Instruction instruction{.opcode = Opcode::edge_negative, .linear = {.a = 1, .c = 3, .width = 8}};
  const std::vector<PacketWord> words = packet(instruction, shape);
  std::vector<WordKind> left;
  std::uint64_t busy_cells = 0;
  for (std::size_t clock = 0; clock < 8; ++clock) {
    chain.step(clock < words.size() ? words[clock] : nothing);
    left.push_back(chain.departure().kind);
    busy_cells += chain.departure().busy_cells;
  }
  std::vector<WordKind> expected(8, WordKind::none);
  expected[1 + 4] = WordKind::instruction;
  CHECK(left == expected);
  CHECK(busy_cells == 2 * 5);
}

TEST_CASE("after random packets, some many words long, every cell holds what the reference holds") {
  CHECK(rc::check([] {
    const isa::ArrayShape shape{*rc::gen::inRange(1U, 70U), 1, *rc::gen::inRange(1U, 100U)};
    const CellShape cell{.word_bits = *rc::gen::inRange(1U, 65U),
                         .ports = *rc::gen::inRange(0U, 6U),
                         .alu_bits = *rc::gen::inRange(0U, 40U),
                         .shift_bits = *rc::gen::inRange(0U, 40U)};
    const auto instructions = *rc::gen::resize(
        20, rc::gen::container<std::vector<Instruction>>(test::arbitrary_instruction(shape, shape.memory_bits, 0)));
    Chain chain(shape.width + 3, shape.memory_bits, cell);
    chain.begin(shape.width);
    reference::ReferenceArray judge(shape);
    std::size_t left = 0;
    const auto look = [&] {
      const Departure& departure = chain.departure();
      if (departure.kind == WordKind::none) return;
      RC_ASSERT(departure.enabled_pixels == judge.enabled_pixels());
      judge.execute(instructions[left++]);
      require_same(*departure.snapshot, judge, shape);
    };
    for (const Instruction& instruction : instructions) {
      for (const PacketWord& word : packet(instruction, cell)) {
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
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  Chain chain(2, 8, shape);
  chain.begin(2);
  const Instruction set{.opcode = Opcode::set_constant, .fields = {colour}, .constant = 200};
  for (const Instruction& one : {Instruction{.opcode = Opcode::enable_all}, set}) chain.step(packet(one, shape).at(0));
  chain.step(packet({.opcode = Opcode::enable_invert}, shape).at(0));
  CHECK(chain.cells().read(0, colour) == 200);
  chain.step(packet(set, shape, true).at(0));
  CHECK(chain.cells().read(0, colour) == 0);
  CHECK_FALSE(chain.cells().enabled(0));
}

TEST_CASE("pixel x is at the refresh port in the x-th clock after that in which the shift chain took the line") {
  constexpr std::uint32_t pixels = 3;
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  Chain chain(5, 8, shape);
  chain.begin(pixels);
  const Instruction ramp{.opcode = Opcode::load_linear, .fields = {colour}, .linear = {.a = 5, .c = 7, .width = 10}};
  chain.step(packet({.opcode = Opcode::enable_all}, shape).at(0));
  for (const PacketWord& word : packet(ramp, shape)) chain.step(word);
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
    Chain chain(6, 8, {.word_bits = 8, .ports = 1});
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

TEST_CASE("a clear packet clears a cell with its last beat") {
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  Chain chain(1, 8, shape);
  chain.begin(1);
  chain.step(packet({.opcode = Opcode::enable_all}, shape).at(0));
  chain.step(packet({.opcode = Opcode::set_constant, .fields = {colour}, .constant = 9}, shape).at(0));
  PacketWord clear = scan_line::clear_packet(2);
  chain.step(clear);
  CHECK(chain.cells().read(0, colour) == 9);
  chain.step(scan_line::next_beat(clear, shape));
  CHECK(chain.cells().read(0, colour) == 0);
  CHECK_FALSE(chain.cells().enabled(0));
}

TEST_CASE("a packet that is not followed by its own next beat is an error") {
  constexpr CellShape shape{.word_bits = 4, .ports = 1};
  const std::vector<PacketWord> beats =
      packet({.opcode = Opcode::edge_negative, .linear = {.a = 1, .c = 3, .width = 8}}, shape);
  Chain chain(2, 8, shape);
  chain.begin(2);
  CHECK_THROWS_AS(chain.step(beats.at(1)), std::logic_error);
  chain.step(beats.at(0));
  CHECK_THROWS_AS(chain.step(nothing), std::logic_error);
}
