#include "hw/scan_line/cells.h"

#include <rapidcheck.h>

#include "hw/isa/opcodes.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using scan_line::Cells;
using scan_line::CellShape;
using scan_line::CellStep;
using scan_line::instruction_packet;
using scan_line::Packet;

namespace {

__extension__ using Wide = __int128;

std::vector<CellStep> steps_of(const Packet& packet, const CellShape& shape) {
  std::vector<CellStep> steps;
  compute_steps(packet, shape, steps);
  return steps;
}

/// Executes the first `beats` beats of the packet in cell 0, using the ports available in each.
void carry_out(Cells& cell, const Instruction& instruction, const CellShape& shape, std::uint32_t beats) {
  const Packet packet = instruction_packet(instruction, shape);
  const std::vector<CellStep> steps = steps_of(packet, shape);
  for (std::uint32_t beat = 0; beat < beats; ++beat) cell.execute(packet, std::span(steps).subspan(beat, 1), {0, 1});
}

/// Checks that a result at this beat is rejected.
void check_too_soon(Packet packet, std::uint32_t beat, const CellShape& shape) {
  packet.accesses.result = beat;
  CHECK_THROWS_AS(steps_of(packet, shape), std::logic_error);
}

}  // namespace

TEST_CASE("a cell reads and writes at most one word per port and clock") {
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  constexpr Field across{4, 16};   // words 0, 1 and 2
  constexpr Field within{24, 16};  // words 3 and 4
  const Instruction copy{.opcode = Opcode::copy, .fields = {within, across}};
  Cells cell(1, 40);
  carry_out(cell, {.opcode = Opcode::enable_all}, shape, 1);
  carry_out(cell, {.opcode = Opcode::set_constant, .fields = {across}, .constant = 0xabcd}, shape, 3);
  CHECK(cell.read(0, {4, 4}) == 0xd);
  CHECK(cell.read(0, {8, 8}) == 0xbc);
  CHECK(cell.read(0, {16, 4}) == 0);  // the first write shared the clock of the second word; the third follows
  carry_out(cell, {.opcode = Opcode::set_constant, .fields = {across}, .constant = 0xabcd}, shape, 4);
  CHECK(cell.read(0, across) == 0xabcd);
  carry_out(cell, copy, shape, 4);
  CHECK(cell.read(0, within) == 0xcd);  // three clocks of reading, one of writing
  carry_out(cell, copy, shape, 5);
  CHECK(cell.read(0, within) == 0xabcd);
}

TEST_CASE("a cell that acts before its fields have been read is an error") {
  constexpr CellShape shape{.word_bits = 8, .ports = 1};
  const Packet packet = instruction_packet({.opcode = Opcode::field_lt, .fields = {Field{0, 8}, Field{8, 8}}}, shape);
  CHECK(packet.beats == 2);
  CHECK_NOTHROW(steps_of(packet, shape));
  check_too_soon(packet, 0, shape);
}

TEST_CASE("a cell that acts before it has found all bits of a root is an error") {
  const CellShape shape{.word_bits = 8};
  const Packet packet = instruction_packet({.opcode = Opcode::root, .fields = {Field{0, 7}}}, shape);
  CHECK_NOTHROW(steps_of(packet, shape));
  for (std::uint32_t beat = 0; beat < packet.accesses.result; ++beat) check_too_soon(packet, beat, shape);
}

TEST_CASE("a cell that acts before its operands have been processed is an error") {
  const Instruction compare{.opcode = Opcode::linear_ge, .fields = {Field{0, 8}}, .linear = {.width = 12, .shift = 2}};
  for (const CellShape& shape : {CellShape{.word_bits = 16, .ports = 1, .alu_bits = 4, .shift_bits = 1},
                                 CellShape{.word_bits = 16, .ports = 1, .alu_bits = 0, .shift_bits = 2},
                                 CellShape{.word_bits = 16, .ports = 1, .alu_bits = 5, .shift_bits = 0}}) {
    const Packet packet = instruction_packet(compare, shape);
    REQUIRE(packet.beats > 1);
    CHECK_NOTHROW(steps_of(packet, shape));
    for (std::uint32_t beat = 0; beat + 1 < packet.beats; ++beat) check_too_soon(packet, beat, shape);
  }
}

TEST_CASE("a cell below a tree gets the bits of C + A x + S x x at any tree width") {
  CHECK(rc::check([] {
    const auto any = [](unsigned bits) {
      return *rc::gen::inRange(-(std::int64_t{1} << bits), std::int64_t{1} << bits);
    };
    const isa::Linear linear{.a = any(40), .c = any(50), .width = *rc::gen::inRange<std::uint16_t>(1, 63)};
    const std::int64_t square = any(30);
    const CellShape shape{.word_bits = *rc::gen::inRange(1U, 65U), .tree_bits = *rc::gen::inRange(1U, 65U)};
    const Packet packet = instruction_packet({.opcode = Opcode::edge_negative, .linear = linear}, shape, {.a = square});
    for (std::uint32_t x = 0; x < 40; ++x) {
      const auto expected = static_cast<std::uint64_t>((static_cast<Wide>(square) * x + linear.a) * x + linear.c);
      const std::uint64_t mask = (std::uint64_t{1} << linear.width) - 1;
      RC_ASSERT((received_sum(packet, packet.words, x, shape) & mask) == (expected & mask));
    }
  }));
}
