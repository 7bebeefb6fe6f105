#include "hw/scan_line/packet.h"

#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "tests/support/plain_cells.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using scan_line::Beat;
using scan_line::BeatWords;
using scan_line::CellShape;
using scan_line::instruction_packet;
using scan_line::Packet;

namespace {

std::int64_t any(unsigned bits) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-(std::int64_t{1} << bits), std::int64_t{1} << bits));
}

/// Checks that the words of every beat in all cells, and the sums there, equal those of cell-by-cell adders.
void check_adders(const isa::Linear& linear, std::int64_t square, std::uint32_t word_bits) {
  constexpr std::uint32_t cells = 9;
  const CellShape shape{.word_bits = word_bits};
  const Packet packet = instruction_packet({.opcode = Opcode::edge_negative, .linear = linear}, shape, {.a = square});
  test::PlainChain judge(cells, 8, shape);
  for (std::uint32_t clock = 0; clock < packet.beats + cells; ++clock) {
    judge.step(clock < packet.beats ? Beat{&packet, clock} : Beat{});
    for (std::uint32_t cell = 1; cell < cells; ++cell) {
      if (const test::PlainBeat* const beat = judge.beat_in(cell))
        RC_ASSERT(arriving_words({&packet, beat->number}, cell, shape) == (BeatWords{beat->f, beat->a, beat->aa}));
      if (clock >= cell) RC_ASSERT(received_sum(packet, clock - cell + 1, cell, shape) == judge.cells().sum(cell));
    }
  }
}

}  // namespace

TEST_CASE("a packet's words and each cell's sums equal those of adders at every word width") {
  CHECK(rc::check([] {
    const auto smaller = *rc::gen::inRange(0U, 62U);
    const auto width = *rc::gen::inRange<std::uint16_t>(1, isa::max_linear_width + 1);
    const isa::Linear linear{.a = any(56) >> smaller, .c = any(61) >> smaller, .width = width};
    for (std::uint32_t word_bits = 1; word_bits <= 64; ++word_bits) check_adders(linear, 0, word_bits);
  }));
}

TEST_CASE("a packet with squares adds the second difference to words and sums") {
  CHECK(rc::check([] {
    const auto smaller = *rc::gen::inRange(0U, 56U);
    const auto width = *rc::gen::inRange<std::uint16_t>(1, isa::max_linear_width + 1);
    const isa::Linear linear{.a = any(55) >> smaller, .c = any(60) >> smaller, .width = width};
    for (std::uint32_t word_bits = 1; word_bits <= 64; ++word_bits) check_adders(linear, any(50) >> smaller, word_bits);
  }));
}

TEST_CASE("a packet occupies a cell for its words or for its memory reads and writes") {
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
      // A word read, one trial per bit of the root, and a word written in the clock of the last.
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

TEST_CASE("beats include shifts of misaligned operands and an ALU narrower than a word") {
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
      // No shift; all bits at once, in halves, and one by one.
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = plain}, {32, 1, 32, 32}, 1},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = plain}, {32, 1, 16, 32}, 2},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = plain}, {32, 1, 1, 32}, 28},
      // Two words enter; the 28 bits above the fraction are shifted down by 8 and compared.
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = fine}, {32, 1, 32, 32}, 1 + 2},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = fine}, {32, 1, 32, 3}, 1 + 3 + 1},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = fine}, {32, 1, 0, 0}, 2},
      {{.opcode = Opcode::linear_ge, .fields = {low}, .linear = fine}, {32, 1, 0, 1}, 1 + 8 + 1},
      // The bits span two words, from bit 24 on, and are shifted up by 16.
      {{.opcode = Opcode::linear_ge, .fields = {across}, .linear = fine}, {32, 1, 32, 32}, 1 + 2 + 1},
      {{.opcode = Opcode::linear_ge, .fields = {across}, .linear = fine}, {32, 1, 32, 8}, 1 + 4 + 1},
      // Shifts while the port is busy with reads are free.
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30, .shift = 1}}, {32, 1, 32, 32}, 2},
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30, .shift = 1}}, {32, 0, 32, 32}, 2},
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30, .shift = 1}}, {32, 0, 0, 0}, 1},
      {{.opcode = Opcode::keep_max, .fields = {low}, .linear = {.width = 30, .shift = 5}}, {32, 1, 32, 1}, 6},
      // The sign of F is its highest bit.
      {{.opcode = Opcode::edge_negative, .linear = fine}, {32, 1, 1, 1}, 2},
      {{.opcode = Opcode::stripe, .linear = fine}, {32, 1, 1, 1}, 2},
      // F + t has the bits of t; only those bits of F are needed.
      {{.opcode = Opcode::linear_plus, .fields = {Field{0, 8}}, .linear = fine}, {32, 1, 4, 8}, 1 + 1 + 2},
      // Shifted to the place of the first field; two or three words are read one after the other.
      {{.opcode = Opcode::field_lt, .fields = {low, across}}, {32, 1, 32, 32}, 3 + 1},
      {{.opcode = Opcode::field_lt, .fields = {across, low}}, {32, 1, 32, 32}, 3 + 2},
      {{.opcode = Opcode::field_lt, .fields = {low, beyond}}, {32, 1, 10, 2}, 2 + 2 + 2 - 1},
      // All words are read, then the second operand is shifted by 4 bits and the third by 24.
      {{.opcode = Opcode::bit_and, .fields = {low, beyond, across}}, {32, 1, 20, 12}, 3 + 1 + 2 + 1 - 1},
      {{.opcode = Opcode::copy, .fields = {low, across}}, {32, 1, 1, 12}, 2 + 1},
      {{.opcode = Opcode::copy, .fields = {low, beyond}}, {32, 1, 1, 1}, 1 + 4 - 1},
      {{.opcode = Opcode::copy, .fields = {low, Field{64, 20}}}, {32, 1, 1, 1}, 2},
      // Constants and bits for E need no shift.
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

TEST_CASE("a tree delivers F a few bits per clock and fields still arrive word by word") {
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
