#include "hw/isa/text.h"

#include <rapidcheck.h>

#include "hw/isa/facts.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"
#include "tests/unit/isa/sample.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

using test::sample_program;

std::string printed(const Program& program) {
  std::ostringstream out;
  print(out, program);
  return out.str();
}

/// The only instruction of a Program on an array with a field Z of 8 bits and a primitive.
Instruction instruction_of(const std::string& line) {
  const std::string text =
      ".array width=4 height=4 memory_bits=32\n.field Z [0+:8] depth\n.primitive \"p\"\n.segment width=4 height=4\n" +
      line;
  return parse(text, "t").segments.at(0).instructions.at(0);
}

TEST_CASE("the sample Program prints as the expected text") {
  CHECK(printed(sample_program()) == R"(# csgsim program
.array width=8 height=4 memory_bits=40
.machine name="pixel-planes-4+alu.bits=4" kind="frame-buffer" figures=["alu.bits=4", "scan_out.port=shared"]
.frame colour_base=17 colour_bits=12 background=41136
.depth perspective=true near=0.1 far=1e+300
.model file="dir/model.csg" primitives=2 unions=1 differences=0 intersections=0 halfspaces=12
.compile strategy="auto" colouring="field" z_bits=8 fraction_bits=4 edge_on_fraction=0.3 stack_bits=1 tree_depth=2 rendered=2 classified=1 depth_tests=3 effects=["shadow", "fog, thick"]
.field Z1 [0+:8] candidate_depth
.field in [16] stack
.field "two words" [8+:8] depth
.primitive "cube \"a\""  # p0
.primitive "ball\x0a"  # p1
.extent first=0 last=3
.extent first=2 last=2

.segment x=1 y=0 width=7 height=4 primitives=2 halfspaces=12 kept_primitives=1 kept_halfspaces=9 comparisons=4  # s0
  enable_all                                            ; setup                     # i0
  set_constant "two words", 255                         ; setup                     # i1
  keep_max Z1, 12*x - 7*y + 991 (w20 >> 4)              ; render p0                 # i2
  linear_ge Z1, -x + y - 300 (w12)                      ; classify p0 against p1    # i3
  edge_negative 0 (w1)                                  ; classify against p1       # i4
  bit_and_not in, in, [39]                              ; stack p1                  # i5
  copy "two words", Z1                                  ; merge p1                  # i6
  skip_if_none 1                                        ; merge p1                  # i7
  global_or                                             ; merge p1                  # i8

.segment x=0 y=3 width=1 height=1 primitives=0 halfspaces=0 kept_primitives=0 kept_halfspaces=0 comparisons=0  # s1
)");
}

TEST_CASE("the sample Program survives a text round trip") {
  CHECK(parse(printed(sample_program()), "t") == sample_program());
}

TEST_CASE("every Program survives a text round trip") {
  CHECK(rc::check("parse() inverts print()", [] {
    const auto program = *test::arbitrary_program({37, 20, 72}, 60, 2);
    RC_ASSERT(parse(printed(program), "t") == program);
  }));
}

TEST_CASE("printing a parsed Program reproduces its text") {
  CHECK(rc::check("a parsed Program prints the same text", [] {
    const std::string text = printed(*test::arbitrary_program({5, 3, 40}, 20, 2));
    RC_ASSERT(printed(parse(text, "t")) == text);
  }));
}

TEST_CASE("doubles in a Program's text survive a round trip exactly") {
  for (const double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, 123456789012345678.0}) {
    Program program = sample_program();
    program.facts->compile.edge_on_fraction = value;
    CHECK(parse(printed(program), "t").facts->compile.edge_on_fraction == value);
  }
}

TEST_CASE("names of arbitrary bytes in a Program's text survive a round trip") {
  Program program = sample_program();
  std::string all;
  for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
  program.facts->model.file = all;
  program.facts->primitives[0] = all;
  program.facts->fields[0].name = all;
  program.facts->fields[1].name = "x";
  program.facts->compile.effects = {all, "", all};
  CHECK(parse(printed(program), "t") == program);
}

TEST_CASE("the text of a Program may have any whitespace and line endings") {
  const std::string text =
      "# a program\r\n\r\n\t.array  height=4 width=4   memory_bits=32 # wide\r\n"
      ".field Z [ 0 +: 8 ] depth\r\n.segment width=4 height=4\r\n"
      "set_constant Z,255;render#c\r\n  keep_max   Z ,7 -x+ 2 * y(w12>>2)";
  const Program program = parse(text, "t");
  REQUIRE(program.segments.at(0).instructions.size() == 2);
  CHECK(program.segments[0].instructions[0].constant == 255);
  CHECK(program.segments[0].instructions[0].origin == Origin{Purpose::render, no_primitive, no_node});
  CHECK(program.segments[0].instructions[1].linear == Linear{-1, 2, 7, 12, 2});
}

TEST_CASE("linear expressions in a Program's text may have terms in any order") {
  CHECK(instruction_of("edge_negative x (w9)").linear == Linear{1, 0, 0, 9, 0});
  CHECK(instruction_of("edge_negative +y (w9)").linear == Linear{0, 1, 0, 9, 0});
  CHECK(instruction_of("edge_negative -5 + 3*y - 2*x (w9 >> 3)").linear == Linear{-2, 3, -5, 9, 3});
  CHECK(instruction_of("edge_negative 0*x + 0 (w9)").linear == Linear{0, 0, 0, 9, 0});
}

TEST_CASE("constants in a Program's text may be hexadecimal") {
  CHECK(instruction_of("set_constant Z, 0xfF").constant == 255);
  CHECK(instruction_of("set_constant Z, 017").constant == 17);
}

TEST_CASE("fields in a Program's text may be given by name or by position") {
  CHECK(instruction_of("set_constant Z, 1") == instruction_of("set_constant [0+:8], 1"));
  CHECK(instruction_of("set_constant \"Z\", 1") == instruction_of("set_constant [0+:8], 1"));
  CHECK(instruction_of("enable_load [7]") == instruction_of("enable_load [7+:1]"));
}

TEST_CASE("a hundred thousand named fields are read and printed quickly") {
  constexpr std::size_t count = 100'000;
  std::string text = ".array width=8 height=8 memory_bits=8\n";
  for (std::size_t i = 0; i < count; ++i) text += fmt::format(".field f{} [0] stack\n", i);
  text += ".segment width=8 height=8\n";
  for (std::size_t i = 0; i < count; ++i) text += fmt::format("enable_load f{}\n", count - 1 - i);
  const Program program = parse(text, "t");
  CHECK(program.facts->fields.size() == count);
  CHECK(program.segments[0].instructions.size() == count);
  const std::string again = printed(program);
  CHECK(again.find("  enable_load f0 ") != std::string::npos);
  CHECK(again.find("  enable_load f1") == std::string::npos);
}

TEST_CASE("an instruction without an origin has the origin `setup`") {
  CHECK(instruction_of("enable_all").origin == Origin{});
}

}  // namespace
