#include "hw/isa/manual.h"

#include "hw/isa/instruction.h"
#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/isa/sample.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

TEST_CASE("the instruction set's manual has rows for operands and clocks and purposes") {
  const std::string page = instruction_set_page();
  for (const char* const row : {
           "| 12 | `linear_le` | source, linear | any | 36 + 3w | E := E and F <= s |\n",
           "| 18 | `set_constant` | target, constant | any | 24 + n | where E: t := k |\n",
           "| 23 | `bit_and` | target, source, source | equal | 60 | where E: t := s and r, bit by bit |\n",
           "| 28 | `global_or` |  |  | 6 | the host receives whether E is 1 at any pixel |\n",
           "| 31 | `add` | target, source | s no wider than t | 42 | where E: t := the low bits of t + s; the carry "
           "out of the "
           "top bit is lost |\n",
           "| twice as many: to compare, then to write | `keep_max` `keep_min` |\n",
           "| 1 + latency of the trees + levels of the global OR | `global_or` `skip_if_none` |\n",
           "| `classify` | a primitive of an active tree compared with Z1 |\n",
       }) {
    CHECK(test::contains(page, row));
  }
}

TEST_CASE("the manual lists the bits of each command on a link") {
  const std::string page = instruction_set_page();
  for (const std::string_view row :
       {"| 0 | `enable_all` |  |  | 6 |", "| 9 | `edge_negative` | linear |  | 18 + 3w |",
        "| 18 | `set_constant` | target, constant | any | 24 + n |",
        "| 25 | `bit_xor` | target, source, source | equal | 60 |", "| 30 | `skip_if_none` | count |  | 38 |",
        "| 32 | `stripe` | linear |  | 18 + 3w |", "| 61 | segment | 70 |", "| 62 | end of segment | 6 |",
        "| 63 | end of frame | 24 |"})
    CHECK(test::contains(page, std::string(row)));
}

}  // namespace
