#include "hw/scan_line/cells.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <stdexcept>
#include <vector>

#include "hw/isa/opcodes.h"

using namespace csgsim;
using scan_line::Cells;
using scan_line::CellShape;
using scan_line::instruction_packet;
using scan_line::next_beat;
using scan_line::PacketWord;

namespace {

__extension__ using Wide = __int128;

constexpr std::uint32_t cells = 40;

/// The low bits of C + A*x, and S*x*x besides.
std::uint64_t low_bits(const isa::Linear& linear, std::uint32_t x, std::int64_t square = 0) {
  const Wide sum = (static_cast<Wide>(square) * x + linear.a) * x + linear.c;
  return static_cast<std::uint64_t>(sum) & ((std::uint64_t{1} << linear.width) - 1);
}

/// The running sum of every cell, when all words of the packet have been there.
std::vector<std::uint64_t> running_sums(const isa::Linear& linear, std::uint32_t word_bits, std::int64_t square = 0) {
  const CellShape shape{.word_bits = word_bits};
  Cells chain(cells, 8, shape);
  PacketWord beat = instruction_packet({.opcode = isa::Opcode::edge_negative, .linear = linear}, shape, {.a = square});
  for (bool more = true; more;) {
    PacketWord word = beat;
    for (std::uint32_t cell = 0; cell < cells; ++cell) chain.add(cell, word);
    more = !beat.last();
    if (more) beat = next_beat(beat, shape);
  }
  std::vector<std::uint64_t> sums;
  for (std::uint32_t cell = 0; cell < cells; ++cell) {
    sums.push_back(chain.sum(cell) & ((std::uint64_t{1} << linear.width) - 1));
  }
  return sums;
}

}  // namespace

TEST_CASE("the running sum in every cell is C + A*x, wrapped, for every width of F and of a word") {
  CHECK(rc::check([] {
    const std::int64_t a = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(-(1LL << 56), 1LL << 56));
    const std::int64_t c = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(-(1LL << 61), 1LL << 61));
    const auto smaller = *rc::gen::inRange(0U, 62U);
    for (std::uint16_t width = 1; width <= isa::max_linear_width; ++width) {
      const isa::Linear linear{.a = a >> smaller, .c = c >> smaller, .width = width};
      std::vector<std::uint64_t> expected;
      for (std::uint32_t x = 0; x < cells; ++x) expected.push_back(low_bits(linear, x));
      for (std::uint32_t word_bits = 1; word_bits <= 64; ++word_bits) {
        RC_ASSERT(running_sums(linear, word_bits) == expected);
      }
    }
  }));
}

TEST_CASE("the carry of one packet does not reach the next") {
  constexpr CellShape shape{.word_bits = 4};
  Cells chain(1, 8, shape);
  const isa::Instruction full{.opcode = isa::Opcode::edge_negative, .linear = {.a = 15, .c = 15, .width = 8}};
  PacketWord word = instruction_packet(full, shape);
  chain.add(0, word);
  CHECK(word.f == 14);
  PacketWord next =
      instruction_packet({.opcode = isa::Opcode::edge_negative, .linear = {.a = 1, .c = 1, .width = 4}}, shape);
  chain.add(0, next);
  CHECK(next.f == 2);
}

namespace {

using isa::Field;
using isa::Instruction;
using isa::Opcode;

/// Carries the packet out in cell 0, at each beat what the ports can do.
void carry_out(Cells& cell, const Instruction& instruction, const CellShape& shape, std::uint32_t beats) {
  PacketWord beat = instruction_packet(instruction, shape);
  for (std::uint32_t i = 0; i < beats; ++i) {
    cell.fetch(0, beat);
    if (beat.number >= beat.accesses.work_from) cell.work(0, beat);
    if (beat.number == beat.accesses.result) cell.act(0, beat);
    if (beat.number >= beat.accesses.result) cell.store(0, beat);
    beat = next_beat(beat, shape);
  }
}

}  // namespace

TEST_CASE("a cell reads and writes a word of its memory at each port in a clock, and no more") {
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  constexpr Field across{4, 16};   // words 0, 1 and 2
  constexpr Field within{24, 16};  // words 3 and 4
  const Instruction copy{.opcode = Opcode::copy, .fields = {within, across}};
  Cells cell(1, 40, shape);
  carry_out(cell, {.opcode = Opcode::enable_all}, shape, 1);
  carry_out(cell, {.opcode = Opcode::set_constant, .fields = {across}, .constant = 0xabcd}, shape, 3);
  CHECK(cell.read(0, {4, 4}) == 0xd);
  CHECK(cell.read(0, {8, 8}) == 0xbc);
  CHECK(cell.read(0, {16, 4}) == 0);  // the first write was in the clock of the second word, the third is to come
  carry_out(cell, {.opcode = Opcode::set_constant, .fields = {across}, .constant = 0xabcd}, shape, 4);
  CHECK(cell.read(0, across) == 0xabcd);
  carry_out(cell, copy, shape, 4);
  CHECK(cell.read(0, within) == 0xcd);  // three clocks of reading, one of writing
  carry_out(cell, copy, shape, 5);
  CHECK(cell.read(0, within) == 0xabcd);
}

TEST_CASE("a cell that would act before its fields have been read is an error") {
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  Cells cell(1, 40, shape);
  PacketWord beat = instruction_packet({.opcode = Opcode::field_lt, .fields = {Field{0, 8}, Field{8, 8}}}, shape);
  CHECK(beat.beats == 2);
  cell.fetch(0, beat);
  CHECK_THROWS_AS(cell.act(0, beat), std::logic_error);
}

TEST_CASE("with squares every cell has C + A*x + S*x*x, wrapped, by the second difference alone") {
  CHECK(rc::check([] {
    const auto smaller = *rc::gen::inRange(0U, 56U);
    const auto any = [&](unsigned bits) {
      return *rc::gen::resize(rc::kNominalSize,
                              rc::gen::inRange(-(std::int64_t{1} << bits), std::int64_t{1} << bits)) >>
             smaller;
    };
    const std::int64_t square = any(50);
    const auto width = *rc::gen::inRange<std::uint16_t>(1, isa::max_linear_width + 1);
    const isa::Linear linear{.a = any(55), .c = any(60), .width = width};
    std::vector<std::uint64_t> expected;
    for (std::uint32_t x = 0; x < cells; ++x) expected.push_back(low_bits(linear, x, square));
    for (std::uint32_t word_bits = 1; word_bits <= 64; ++word_bits)
      RC_ASSERT(running_sums(linear, word_bits, square) == expected);
  }));
}

TEST_CASE("a cell that acts before it has found all bits of a root says so") {
  const CellShape shape{.word_bits = 8};
  Cells chain(1, 16, shape);
  const PacketWord beat = instruction_packet({.opcode = Opcode::root, .fields = {Field{0, 7}}}, shape);
  chain.fetch(0, beat);
  chain.try_root(0, beat);
  CHECK_THROWS_AS(chain.act(0, beat), std::logic_error);
}

TEST_CASE("a packet occupies a cell for its words, or for the reads and then the writes of its memory") {
  struct Row {
    Instruction instruction;
    CellShape shape;
    std::uint32_t beats;
  };
  const Field low{0, 8};
  const Field high{8, 8};
  const Field across{28, 8};
  const Field wide{20, 32};
  const std::vector<Row> rows{
      {{.opcode = Opcode::enable_all}, {32, 1}, 1},
      {{.opcode = Opcode::enable_load, .fields = {Field{3, 1}}}, {32, 1}, 1},
      {{.opcode = Opcode::edge_negative, .linear = {.width = 40}}, {32, 1}, 2},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = {.width = 30}}, {32, 1}, 1},
      {{.opcode = Opcode::linear_ge, .fields = {across}, .linear = {.width = 30}}, {32, 1}, 2},
      {{.opcode = Opcode::linear_ge, .fields = {across}, .linear = {.width = 40}}, {32, 1}, 2},
      {{.opcode = Opcode::load_linear, .fields = {low}, .linear = {.width = 30}}, {32, 1}, 1},
      {{.opcode = Opcode::load_linear, .fields = {across}, .linear = {.width = 40}}, {32, 1}, 3},
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30}}, {32, 1}, 2},
      {{.opcode = Opcode::keep_max, .fields = {across}, .linear = {.width = 30}}, {32, 1}, 4},
      {{.opcode = Opcode::keep_max, .fields = {across}, .linear = {.width = 30}}, {32, 2}, 2},
      {{.opcode = Opcode::copy, .fields = {low, high}}, {32, 1}, 2},
      {{.opcode = Opcode::copy, .fields = {low, high}}, {32, 8}, 2},
      {{.opcode = Opcode::copy, .fields = {low, high}}, {32, 0}, 1},
      {{.opcode = Opcode::field_lt, .fields = {low, high}}, {32, 1}, 2},
      {{.opcode = Opcode::field_lt, .fields = {low, high}}, {32, 2}, 1},
      {{.opcode = Opcode::bit_and, .fields = {low, high, across}}, {32, 1}, 4},
      {{.opcode = Opcode::xor_constant, .fields = {low}, .constant = 1}, {32, 1}, 2},
      {{.opcode = Opcode::add, .fields = {low, high}}, {32, 1}, 3},
      {{.opcode = Opcode::add, .fields = {wide, low}}, {16, 1}, 7},
      {{.opcode = Opcode::add, .fields = {wide, low}}, {16, 0}, 2},
      {{.opcode = Opcode::stripe, .linear = {.width = 33}}, {32, 1}, 2},
      {{.opcode = Opcode::set_constant, .fields = {wide}, .constant = 1}, {16, 1}, 4},
      {{.opcode = Opcode::set_constant, .fields = {wide}, .constant = 1}, {16, 3}, 2},
      {{.opcode = Opcode::squares, .linear = {.width = 40}}, {32, 1}, 1},
      {{.opcode = Opcode::linear_plus, .fields = {low}, .linear = {.width = 30}}, {32, 1}, 2},
      {{.opcode = Opcode::linear_minus, .fields = {across}, .linear = {.width = 40}}, {32, 1}, 4},
      // A word read, a trial each of the root's bits, and a word written in the clock of the last.
      {{.opcode = Opcode::root, .fields = {Field{0, 31}}}, {32, 1}, 1 + 15},
      {{.opcode = Opcode::root, .fields = {Field{0, 31}}}, {32, 0}, 15},
      {{.opcode = Opcode::root, .fields = {Field{0, 61}}}, {32, 1}, 2 + 30 + 1},
      // The trials of 17 bits and more take two clocks; five words are written.
      {{.opcode = Opcode::root, .fields = {Field{0, 61}}}, {16, 1}, 4 + 14 + 2 * 16 + 3},
      {{.opcode = Opcode::root, .fields = {Field{0, 7}}}, {1, 0}, 3 + 4 + 5},
  };
  for (const Row& row : rows) {
    CAPTURE(isa::name_of(row.instruction.opcode));
    CAPTURE(row.shape.ports);
    CHECK(instruction_packet(row.instruction, row.shape).beats == row.beats);
  }
}

TEST_CASE("an operand that lies elsewhere is moved word by word, and the ALU goes through the bits as wide as it is") {
  struct Row {
    Instruction instruction;
    CellShape shape;
    std::uint32_t beats;
  };
  const Field low{0, 20};
  const Field across{24, 20};  // words 0 and 1
  const Field beyond{68, 20};  // word 2, from its bit 4
  const isa::Linear plain{.width = 28};
  const isa::Linear fine{.width = 36, .shift = 8};
  const std::vector<Row> rows{
      // Nothing to move, and all bits at once, by halves, and one by one.
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = plain}, {32, 1, 32, 32}, 1},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = plain}, {32, 1, 16, 32}, 2},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = plain}, {32, 1, 1, 32}, 28},
      // Two words come in; the 28 bits above the fraction are moved down by 8 and compared.
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = fine}, {32, 1, 32, 32}, 1 + 2},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = fine}, {32, 1, 32, 3}, 1 + 3 + 1},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = fine}, {32, 1, 0, 0}, 2},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = fine}, {32, 1, 0, 1}, 1 + 8 + 1},
      // They come to lie in two words, from bit 24 on, 16 bits up.
      {{.opcode = Opcode::linear_ge, .fields = {across}, .linear = fine}, {32, 1, 32, 32}, 1 + 2 + 1},
      {{.opcode = Opcode::linear_ge, .fields = {across}, .linear = fine}, {32, 1, 32, 8}, 1 + 4 + 1},
      // What is moved while the port is not free to write costs nothing.
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30, .shift = 1}}, {32, 1, 32, 32}, 2},
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30, .shift = 1}}, {32, 0, 32, 32}, 2},
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30, .shift = 1}}, {32, 0, 0, 0}, 1},
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30, .shift = 5}}, {32, 1, 32, 1}, 6},
      // The sign of F is its highest bit.
      {{.opcode = Opcode::edge_negative, .linear = fine}, {32, 1, 1, 1}, 2},
      {{.opcode = Opcode::stripe, .linear = fine}, {32, 1, 1, 1}, 2},
      // F + t has as many bits as t, and no more of F are of use.
      {{.opcode = Opcode::linear_plus, .fields = {Field{0, 8}}, .linear = fine}, {32, 1, 4, 8}, 1 + 1 + 2},
      // To where the first field lies; two words are read, or three, one after the other.
      {{.opcode = Opcode::field_lt, .fields = {low, across}}, {32, 1, 32, 32}, 3 + 1},
      {{.opcode = Opcode::field_lt, .fields = {across, low}}, {32, 1, 32, 32}, 3 + 2},
      {{.opcode = Opcode::field_lt, .fields = {low, beyond}}, {32, 1, 10, 2}, 2 + 2 + 2 - 1},
      // All are read, then the second is moved by 4 bits and the third by 24.
      {{.opcode = Opcode::bit_and, .fields = {low, beyond, across}}, {32, 1, 20, 12}, 3 + 1 + 2 + 1 - 1},
      {{.opcode = Opcode::copy, .fields = {low, across}}, {32, 1, 1, 12}, 2 + 1},
      {{.opcode = Opcode::copy, .fields = {low, beyond}}, {32, 1, 1, 1}, 1 + 4 - 1},
      {{.opcode = Opcode::copy, .fields = {low, Field{64, 20}}}, {32, 1, 1, 1}, 2},
      // Constants and bits for E lie where they are wanted.
      {{.opcode = Opcode::set_constant, .fields = {across}, .constant = 1}, {32, 1, 1, 1}, 2},
      {{.opcode = Opcode::xor_constant, .fields = {across}, .constant = 1}, {32, 1, 10, 1}, 2 + 2},
      {{.opcode = Opcode::xor_constant, .fields = {across}, .constant = 1}, {32, 1, 5, 1}, 2 + 4 + 2 - 2},
      {{.opcode = Opcode::enable_load, .fields = {Field{13, 1}}}, {32, 1, 1, 1}, 1},
      // Trials of 3 to 17 bits, ten of them in a clock.
      {{.opcode = Opcode::root, .fields = {Field{0, 31}}}, {32, 1, 10, 1}, 1 + 8 + 2 * 7},
  };
  for (const Row& row : rows) {
    CAPTURE(isa::name_of(row.instruction.opcode));
    CAPTURE(row.shape.alu_bits);
    CAPTURE(row.shape.shift_bits);
    CHECK(instruction_packet(row.instruction, row.shape).beats == row.beats);
  }
}

TEST_CASE("a tree brings F by so many bits a clock, and fields still come word by word") {
  const auto beats_with = [](std::uint32_t tree_bits, const Instruction& instruction) {
    return instruction_packet(instruction, {.word_bits = 16, .tree_bits = tree_bits}).beats;
  };
  const Instruction edge{.opcode = Opcode::edge_negative, .linear = {.width = 40}};
  CHECK(beats_with(0, edge) == 3);
  CHECK(beats_with(16, edge) == 3);
  CHECK(beats_with(64, edge) == 3);
  CHECK(beats_with(8, edge) == 5);
  CHECK(beats_with(1, edge) == 40);
  CHECK(beats_with(1, {.opcode = Opcode::copy, .fields = {Field{0, 20}, Field{32, 20}}}) == 2);
}

TEST_CASE("a cell below a tree has the bits of C + A*x + S*x*x, whatever the tree brings in a clock") {
  CHECK(rc::check([] {
    const auto any = [](unsigned bits) {
      return *rc::gen::inRange(-(std::int64_t{1} << bits), std::int64_t{1} << bits);
    };
    const isa::Linear linear{.a = any(40), .c = any(50), .width = *rc::gen::inRange<std::uint16_t>(1, 63)};
    const std::int64_t square = any(30);
    const CellShape shape{.word_bits = *rc::gen::inRange(1U, 65U), .tree_bits = *rc::gen::inRange(1U, 65U)};
    Cells below(cells, 8, shape);
    PacketWord beat = instruction_packet({.opcode = Opcode::edge_negative, .linear = linear}, shape, {.a = square});
    for (std::uint32_t n = 0; n < beat.words; ++n, beat = next_beat(beat, shape))
      for (std::uint32_t cell = 0; cell < cells; ++cell) below.take(cell, beat);
    for (std::uint32_t x = 0; x < cells; ++x)
      RC_ASSERT((below.sum(x) & ((std::uint64_t{1} << linear.width) - 1)) == low_bits(linear, x, square));
  }));
}

TEST_CASE("a cell that acts before its operands have been moved and gone through says so") {
  const Instruction compare{.opcode = Opcode::linear_ge, .fields = {Field{0, 8}}, .linear = {.width = 12, .shift = 2}};
  for (const CellShape& shape : {CellShape{.word_bits = 16, .ports = 1, .alu_bits = 4, .shift_bits = 1},
                                 CellShape{.word_bits = 16, .ports = 1, .alu_bits = 0, .shift_bits = 2},
                                 CellShape{.word_bits = 16, .ports = 1, .alu_bits = 5, .shift_bits = 0}}) {
    Cells cell(1, 16, shape);
    PacketWord beat = instruction_packet(compare, shape);
    REQUIRE(beat.beats > 1);
    for (; !beat.last(); beat = next_beat(beat, shape)) {
      cell.fetch(0, beat);
      cell.work(0, beat);
      CHECK_THROWS_AS(cell.act(0, beat), std::logic_error);
    }
    cell.work(0, beat);
    CHECK_NOTHROW(cell.act(0, beat));
  }
}
