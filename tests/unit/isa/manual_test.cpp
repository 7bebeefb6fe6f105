#include "hw/isa/manual.h"

#include <doctest/doctest.h>

#include "hw/isa/instruction.h"
#include "tests/unit/isa/sample.h"

namespace csgsim::isa {
namespace {

TEST_CASE("the manual tells of every instruction, its meaning, and every purpose") {
  const std::string page = instruction_set_page();
  for (const OpcodeInfo& row : opcode_table) {
    CHECK(test::contains(page, std::string("| `").append(row.name).append("` |")));
    CHECK(test::contains(page, std::string(row.meaning)));
  }
  for (const PurposeInfo& row : purpose_table) CHECK(test::contains(page, std::string(row.meaning)));
}

TEST_CASE("the tables of the manual have a row an instruction") {
  const std::string page = instruction_set_page();
  CHECK(test::contains(page, "| 12 | `linear_le` | source, linear | any | E := E and F <= s |\n"));
}

}  // namespace
}  // namespace csgsim::isa
