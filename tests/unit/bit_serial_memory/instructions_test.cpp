#include "hw/bit_serial_memory/micro_program.h"
#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/bit_serial_memory/columns.h"

// Row commands of whole instructions, summed by hand from the counts of single operations (counts_test.cpp).

using namespace csgsim;
using bit_serial_memory::Design;
using bit_serial_memory::MicroDesign;
using bit_serial_memory::RowCommands;
using bit_serial_memory::RowMap;
using bit_serial_memory::RowOp;
using isa::Instruction;
using isa::Opcode;

namespace {

/// Commands at the sense amplifiers.
struct Gates {
  std::size_t reads = 0;
  std::size_t logic = 0;
  std::size_t writes = 0;

  bool operator==(const Gates&) const = default;
};

RowCommands commands_of(const Instruction& instruction, const MicroDesign& design) {
  return micro_program(instruction, RowMap(100, 9, 7), design);
}

Gates gates_of(const Instruction& instruction, bool enable_latch = false) {
  const RowCommands commands =
      commands_of(instruction, {.design = Design::latches, .enable_latch = enable_latch, .has_wired_or = false});
  const Gates gates{testing::count_of(RowOp::read, commands), testing::count_of(RowOp::logic, commands),
                    testing::count_of(RowOp::write, commands)};
  CHECK(gates.reads + gates.logic + gates.writes == commands.size());
  return gates;
}

std::size_t activations_of(const Instruction& instruction, Design design) {
  return commands_of(instruction, {.design = design}).size();
}

constexpr std::size_t n = 5;  ///< bits of a field
constexpr isa::Field a{0, n};
constexpr isa::Field b{20, n};
constexpr isa::Field c{40, n};

Instruction of_fields(Opcode opcode) { return {.opcode = opcode, .fields = {a, b, c}}; }
Instruction of_constant(Opcode opcode, std::uint64_t constant) {
  return {.opcode = opcode, .fields = {a}, .constant = constant};
}

}  // namespace

TEST_CASE("an instruction on E takes the sum of the gates of its steps") {
  // A bit is read and becomes E; E is moved and written back.
  CHECK(gates_of(of_fields(Opcode::enable_load)) == Gates{1, 1 + 1, 1});
  // E is read and moved to its latch before it is combined.
  CHECK(gates_of(of_fields(Opcode::enable_and)) == Gates{2, 1 + 1 + 1, 1});
  CHECK(gates_of(of_fields(Opcode::enable_xor)) == Gates{2, 1 + 1 + 1, 1});
  // A complement takes one more gate.
  CHECK(gates_of(of_fields(Opcode::enable_and_not)) == Gates{2, 1 + 2 + 1, 1});
  CHECK(gates_of(of_fields(Opcode::enable_invert)) == Gates{1, 1 + 1 + 1, 1});
  // E is stored in every pixel, so the write has no mask.
  CHECK(gates_of(of_fields(Opcode::enable_store)) == Gates{1, 1 + 1, 1});
  // A latch for E saves accesses to the row of E.
  CHECK(gates_of(of_fields(Opcode::enable_load), true) == Gates{1, 1, 0});
  CHECK(gates_of(of_fields(Opcode::enable_and), true) == Gates{1, 1, 0});
  CHECK(gates_of(of_fields(Opcode::enable_store), true) == Gates{0, 1, 1});
}

TEST_CASE("instructions on fields take gates for each bit and access E once") {
  constexpr std::size_t kept = 2;  // gates of a masked write
  CHECK(gates_of(of_constant(Opcode::set_constant, 9)) == Gates{1 + n, 1 + (1 + kept) * n, n});
  CHECK(gates_of(of_fields(Opcode::copy)) == Gates{1 + 2 * n, 1 + kept * n, n});
  CHECK(gates_of(of_fields(Opcode::bit_not)) == Gates{1 + 2 * n, 1 + (1 + kept) * n, n});
  // One operand waits in a latch for the other.
  CHECK(gates_of(of_fields(Opcode::bit_and)) == Gates{1 + 3 * n, 1 + (2 + kept) * n, n});
  CHECK(gates_of(of_fields(Opcode::bit_and_not)) == Gates{1 + 3 * n, 1 + (3 + kept) * n, n});
  // Two gates per bit compute the borrow, which starts with one more, and three update E: it is read, narrowed and
  // written.
  CHECK(gates_of(of_fields(Opcode::field_lt)) == Gates{2 * n + 1, 1 + 2 * n + 3, 1});
  CHECK(gates_of(of_fields(Opcode::field_le)) == Gates{2 * n + 1, 1 + 2 * n + 3, 1});
  CHECK(gates_of(of_fields(Opcode::field_eq)) == Gates{2 * n + 1, 3 * n + 2, 1});
  // Three gates per bit for the sum and one for the choice; the target was already read as an operand.
  CHECK(gates_of(of_fields(Opcode::add)) == Gates{2 * n + 1, 1 + 1 + 4 * n, n});
  // Two bits of 9 are ones; only those rows change.
  CHECK(gates_of(of_constant(Opcode::xor_constant, 9)) == Gates{1 + 2, 1 + 2, 2});
  CHECK(gates_of(of_constant(Opcode::xor_constant, 0)) == Gates{0, 0, 0});
  // Gated writes do not read the target.
  CHECK(gates_of(of_constant(Opcode::set_constant, 9), true) == Gates{0, n, n});
  CHECK(gates_of(of_fields(Opcode::copy), true) == Gates{n, 0, n});
}

TEST_CASE("triple-row-activation instructions take the commands of their operations") {
  // A choice takes 7 commands per bit, or 14 with AND, OR and NOT; AND and OR with E take 4, AND NOT 4 or 6.
  CHECK(activations_of(of_fields(Opcode::copy), Design::majority) == 7 * n);
  CHECK(activations_of(of_fields(Opcode::copy), Design::and_or_not) == 14 * n);
  CHECK(activations_of(of_constant(Opcode::set_constant, 9), Design::majority) == 4 * n);
  CHECK(activations_of(of_constant(Opcode::set_constant, 9), Design::and_or_not) == 2 * 4 + 3 * 6);
  CHECK(activations_of(of_fields(Opcode::enable_and), Design::majority) == 4);
  CHECK(activations_of(of_fields(Opcode::enable_and_not), Design::majority) == 4);
  CHECK(activations_of(of_fields(Opcode::enable_and_not), Design::and_or_not) == 6);
  CHECK(activations_of(of_fields(Opcode::enable_xor), Design::majority) == 7);
  CHECK(activations_of(of_fields(Opcode::enable_load), Design::majority) == 1);
  CHECK(activations_of(of_fields(Opcode::enable_invert), Design::majority) == 2);
  // A borrow takes one command to start and 3 per bit, and its AND with E 4.
  CHECK(activations_of(of_fields(Opcode::field_lt), Design::majority) == 3 * n + 1 + 4);
  CHECK(activations_of(of_fields(Opcode::field_eq), Design::majority) == 4 * n + 3);
}

TEST_CASE("row expressions sum from the top digit and store only the last sign") {
  // 5x: the digit 4 adds 8 bits, which are written; the digit 1 writes only the sign; E is written once more.
  const Instruction edge{.opcode = Opcode::edge_negative, .linear = {.a = 5, .b = 0, .c = 3, .width = 10, .shift = 0}};
  CHECK(gates_of(edge).writes == 8 + 1 + 1);
  // 5x + 8y: the digits 8, 4 and 1 write 7 bits, 8 bits and the sign.
  const Instruction both{.opcode = Opcode::edge_negative, .linear = {.a = 5, .b = 8, .c = 3, .width = 10, .shift = 0}};
  CHECK(gates_of(both).writes == 7 + 8 + 1 + 1);
  // A constant needs no sum: its sign narrows E.
  const Instruction none{.opcode = Opcode::edge_negative, .linear = {.a = 0, .b = 0, .c = 3, .width = 10, .shift = 0}};
  CHECK(gates_of(none).writes == 1);
}

TEST_CASE("a query on a memory sends E to the host or waits for the wired OR") {
  const Instruction query{.opcode = Opcode::skip_if_none, .constant = 1};
  for (const Design design : {Design::and_or_not, Design::majority, Design::latches}) {
    CAPTURE(fmt::format("{}", static_cast<int>(design)));
    const RowCommands sent = commands_of(query, {.design = design});
    REQUIRE(sent.size() == 1);
    CHECK(sent.front().op == RowOp::send);
    CHECK(sent.front().from == bit_serial_memory::WordLines(RowMap(100, 9, 7).enable()));
    const RowCommands wired = commands_of(query, {.design = design, .has_wired_or = true});
    CHECK(testing::count_of(RowOp::wired_or, wired) == 1);
    CHECK(testing::count_of(RowOp::send, wired) == 0);
  }
}
