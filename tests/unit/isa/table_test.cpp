#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "hw/isa/operands.h"

namespace csgsim::isa {
namespace {

TEST_CASE("the row of an opcode stands at its number") {
  for (std::size_t i = 0; i < opcode_table.size(); ++i) {
    CHECK(static_cast<std::size_t>(opcode_table[i].opcode) == i);
    CHECK(info(opcode_table[i].opcode).name == opcode_table[i].name);
  }
}

TEST_CASE("no two opcodes share a name") {
  std::set<std::string_view> names;
  for (const OpcodeInfo& row : opcode_table) CHECK(names.insert(row.name).second);
}

TEST_CASE("every opcode has a meaning") {
  for (const OpcodeInfo& row : opcode_table) CHECK_FALSE(row.meaning.empty());
}

TEST_CASE("operands come without gaps, and a field that F or a constant meets comes first") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    const auto none = std::find(row.operands.begin(), row.operands.end(), OperandKind::none);
    CHECK(std::all_of(none, row.operands.end(), [](OperandKind kind) { return kind == OperandKind::none; }));
    if (has_operand(row, OperandKind::constant)) CHECK(row.operands[0] == OperandKind::target);
    if (has_operand(row, OperandKind::linear))
      CHECK((row.operands[0] == OperandKind::linear || row.operands[1] == OperandKind::linear));
  }
}

TEST_CASE("an instruction writes one field at most, and names it first") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    CHECK(row.operands[1] != OperandKind::target);
    CHECK(row.operands[2] != OperandKind::target);
  }
}

TEST_CASE("clock classes agree with the operands") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    const bool streams = row.clock_class == ClockClass::linear_once || row.clock_class == ClockClass::linear_twice;
    CHECK(streams == has_operand(row, OperandKind::linear));
    const bool a_bit_a_clock = row.clock_class == ClockClass::field || row.clock_class == ClockClass::two_fields;
    if (a_bit_a_clock) CHECK(is_field(row.operands[0]));
    if (row.clock_class == ClockClass::one && is_field(row.operands[0]))
      CHECK(field_widths(row.opcode) == FieldWidths::one);
  }
}

TEST_CASE("enable instructions on fields, and they alone, work on single bits, bit instructions bit by bit") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    CHECK(row.name.starts_with("enable_") == (field_widths(row.opcode) == FieldWidths::one));
    CHECK(row.name.starts_with("bit_") == (field_widths(row.opcode) == FieldWidths::elementwise));
  }
}

TEST_CASE("fields overlap when they share a bit") {
  CHECK(Field{0, 8}.overlaps({7, 1}));
  CHECK_FALSE(Field{0, 8}.overlaps({8, 1}));
  CHECK(Field{4, 1}.overlaps({0, 8}));
}

}  // namespace
}  // namespace csgsim::isa
