#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

TEST_CASE("info() returns the row of an opcode by its number") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    CHECK(&info(row.opcode) == &row);
    CHECK(in_table(row.opcode));
    CHECK(name_of(row.opcode) == row.name);
    CHECK(operands_of(row.opcode) == row.operands);
  }
}

TEST_CASE("in_table() is false for opcode numbers without a row") {
  std::size_t numbers = 0;
  for (unsigned number = 0; number < 256; ++number)
    if (in_table(static_cast<Opcode>(number))) ++numbers;
  CHECK(numbers == opcode_table.size());
  CHECK_FALSE(in_table(static_cast<Opcode>(opcode_table.size())));
}

// The list has the opcodes of the first version; golden Programs (traces) guard the numbers of later ones.
TEST_CASE("opcode numbers stay compatible with files and links") {
  const std::vector<std::string_view> names{
      "enable_all",   "enable_invert", "enable_load",  "enable_and",        "enable_and_not",
      "enable_or",    "enable_xor",    "enable_store", "edge_not_negative", "edge_negative",
      "linear_ge",    "linear_gt",     "linear_le",    "linear_lt",         "linear_eq",
      "load_linear",  "keep_max",      "keep_min",     "set_constant",      "copy",
      "field_lt",     "field_le",      "field_eq",     "bit_and",           "bit_or",
      "bit_xor",      "bit_and_not",   "bit_not",      "global_or",         "xor_constant",
      "skip_if_none", "add",           "stripe",       "squares",           "linear_plus",
      "linear_minus", "root"};
  for (std::size_t number = 0; number < names.size(); ++number)
    CHECK(name_of(static_cast<Opcode>(number)) == names[number]);
}

TEST_CASE("no two opcodes share a name") {
  std::set<std::string_view> names;
  for (const OpcodeInfo& row : opcode_table) CHECK(names.insert(row.name).second);
}

TEST_CASE("every opcode has a meaning") {
  for (const OpcodeInfo& row : opcode_table) CHECK_FALSE(row.meaning.empty());
}

TEST_CASE("operand lists have no gaps; a constant's target is first, F first or second") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    const auto none = std::find(row.operands.begin(), row.operands.end(), OperandKind::none);
    CHECK(std::all_of(none, row.operands.end(), [](OperandKind kind) { return kind == OperandKind::none; }));
    if (has_operand(row.operands, OperandKind::constant)) CHECK(row.operands[0] == OperandKind::target);
    if (has_operand(row.operands, OperandKind::linear))
      CHECK((row.operands[0] == OperandKind::linear || row.operands[1] == OperandKind::linear));
  }
}

TEST_CASE("an instruction writes at most one field and lists it first") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    CHECK(row.operands[1] != OperandKind::target);
    CHECK(row.operands[2] != OperandKind::target);
  }
}

TEST_CASE("an opcode's clock class agrees with its operands") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    const bool streams = row.clock_class == ClockClass::linear_once || row.clock_class == ClockClass::linear_twice;
    CHECK(streams == has_operand(row.operands, OperandKind::linear));
    const bool a_bit_a_clock = row.clock_class == ClockClass::field || row.clock_class == ClockClass::two_fields;
    if (a_bit_a_clock) CHECK(is_field(row.operands[0]));
    if (row.clock_class == ClockClass::one && is_field(row.operands[0])) CHECK(row.widths == FieldWidths::one);
  }
}

TEST_CASE("only enable instructions on fields take single bits") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    CHECK(row.name.starts_with("enable_") == (row.widths == FieldWidths::one));
    CHECK(row.name.starts_with("bit_") == (row.widths == FieldWidths::elementwise));
  }
}

TEST_CASE("the target is the wider of two fields of different width") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    if (row.widths != FieldWidths::narrower) continue;
    CHECK(row.operands[0] == OperandKind::target);
    CHECK(row.operands[1] == OperandKind::source);
  }
}

TEST_CASE("instructions that read their target have one and stripes are linear") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    if (reads_target(row.opcode)) CHECK(row.operands[0] == OperandKind::target);
    if (may_exceed_width(row.opcode)) CHECK(has_operand(row.operands, OperandKind::linear));
    CHECK(reads_target(row.opcode) ==
          (row.meaning.find("> t") != row.meaning.npos || row.meaning.find("< t") != row.meaning.npos ||
           row.meaning.find("t xor k") != row.meaning.npos || row.meaning.find("t + s") != row.meaning.npos ||
           row.meaning.find("F + t") != row.meaning.npos || row.meaning.find("F - t") != row.meaning.npos ||
           row.meaning.find("root of D") != row.meaning.npos));
    CHECK(may_exceed_width(row.opcode) == (row.meaning.find("no overflow") != row.meaning.npos));
  }
}

TEST_CASE("only loads, sums of F and roots take wide fields; skips and squares look ahead") {
  for (const OpcodeInfo& row : opcode_table) {
    CAPTURE(row.name);
    const bool loads_or_adds = row.meaning.starts_with("where E: t := the low bits of F");
    CHECK(allows_wide_fields(row.opcode) == (loads_or_adds || row.clock_class == ClockClass::root));
    CHECK(needs_lookahead(row.opcode) ==
          (has_operand(row.operands, OperandKind::count) || has_operand(row.operands, OperandKind::squares)));
  }
}

TEST_CASE("overlaps() is true for fields that share a bit") {
  CHECK(Field{0, 8}.overlaps({7, 1}));
  CHECK_FALSE(Field{0, 8}.overlaps({8, 1}));
  CHECK(Field{4, 1}.overlaps({0, 8}));
}

}  // namespace
