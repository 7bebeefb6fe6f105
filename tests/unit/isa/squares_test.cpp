#include "hw/isa/binary.h"
#include "hw/isa/text.h"
#include "tests/support/test.h"
#include "tests/unit/isa/sample.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

using namespace test;

const std::string header = ".array width=100 height=64 memory_bits=128\n.segment width=100 height=64\n";

/// Error of a Program with its instructions starting in line 3.
std::string error_of(const std::string& instructions) {
  return refusal([&] { parse(header + instructions, "t"); });
}

Instruction first_of(const std::string& instructions) {
  return parse(header + instructions, "t").segments[0].instructions[0];
}

Instruction squares(const Linear& linear) { return {Opcode::squares, {}, linear, 0, {}}; }

TEST_CASE("squares are parsed in any order of terms and survive a text round trip") {
  const std::string next = "\nedge_negative x (w35)\n";
  for (const auto& [line, read] :
       {std::pair{"squares 3*x*x - 2*x*y + 5*y*y (w35)", Linear{3, -2, 5, 35, 0}},
        {"squares - y*y+7 * x * x (w35)", Linear{7, 0, -1, 35, 0}},
        {"squares x*y ( w35 )", Linear{0, 1, 0, 35, 0}},
        {"squares 0*x*x (w35)", Linear{0, 0, 0, 35, 0}},
        {"squares -4611686018427387903*x*x (w35)", Linear{-4611686018427387903, 0, 0, 35, 0}}}) {
    const std::string text = line;
    const Linear& linear = read;
    CAPTURE(text);
    // The last one is out of range for the segment, but valid as a single instruction.
    if (linear.a > -4) CHECK(first_of(text + next) == squares(linear));
    const std::string printed = text_of(squares(linear), {});
    if (linear.a > -4) CHECK(first_of(printed + next) == squares(linear));
  }
  CHECK(text_of(squares({3, -2, 5, 35, 0}), {}) == "squares 3*x*x - 2*x*y + 5*y*y (w35)");
  CHECK(text_of(squares({-1, 0, 1, 9, 0}), {}) == "squares -x*x + y*y (w9)");
  CHECK(text_of(squares({0, 0, 0, 9, 0}), {}) == "squares 0*x*x (w9)");
}

TEST_CASE("an error in the squares in Program text is reported with its position") {
  CHECK(error_of("squares 3*x (w35)").starts_with("t:3:9: expected a term of A*x*x + B*x*y + C*y*y"));
  CHECK(error_of("squares 3 (w35)").starts_with("t:3:9: expected a term of A*x*x"));
  CHECK(error_of("squares y*x (w35)").starts_with("t:3:9: expected a term of A*x*x"));
  CHECK(error_of("squares x*x").starts_with("t:3:12: expected the width of the next instruction's expression"));
  CHECK(error_of("squares x*x (w35 >> 2)").starts_with("t:3:18: expected )"));
  CHECK(contains(error_of("squares x*x + 2*x*x (w35)"), "two terms of one kind"));
  CHECK(contains(error_of("squares 9223372036854775808*x*x (w35)"), "out of range"));
}

TEST_CASE("squares must come before a linear expression of their width") {
  CHECK(error_of("squares x*x (w35)\nlinear_ge [0+:8], x (w35 >> 4)").empty());
  CHECK(error_of("squares x*x (w35)\nstripe x (w35)").empty());
  CHECK(error_of("enable_all\nsquares x*x (w35)") ==
        "t:4:1: squares are the last instruction of the segment; put one with a linear expression after them");
  CHECK(error_of("squares x*x (w35)\nenable_all\nedge_negative x (w35)") ==
        "t:3:1: squares come before enable_all, which has no linear expression; put an instruction that has one right "
        "after them");
  CHECK(error_of("squares x*x (w35)\nsquares x*x (w35)\nedge_negative x (w35)") ==
        "t:3:1: squares come before squares, which has no linear expression; put an instruction that has one right "
        "after them");
  CHECK(error_of("squares x*x (w35)\nedge_negative x (w34)") ==
        "t:3:1: squares of 35 bits come before a linear expression of 34; make them equally wide");
  CHECK(
      contains(error_of("squares x*x (w35)\n.segment width=1 height=1\nedge_negative x (w35)"), "t:3:1: squares are"));
}

TEST_CASE("a skip must not end between squares and their instruction") {
  const std::string pair = "squares x*x (w35)\nedge_negative x (w35)\nenable_all\n";
  CHECK(error_of("skip_if_none 2\n" + pair).empty());
  CHECK(error_of("skip_if_none 1\n" + pair) ==
        "t:3:1: skip_if_none 1 ends between squares and their instruction; skip both or neither");
  CHECK(error_of("skip_if_none 1\nenable_all\n" + pair).empty());
  CHECK(contains(error_of("skip_if_none 2\nenable_all\n" + pair), "ends between squares"));
}

TEST_CASE("squares and linear expression must stay below 2^62 in sum over the segment") {
  // 100 * 100 A + 100 * 64 B + 64 * 64 C + 100 D + 64 E + F
  constexpr std::int64_t limit = std::int64_t{1} << 62U;
  const auto error = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t rest) {
    return error_of(
        fmt::format("squares {}*x*x + {}*x*y + {}*y*y (w62)\nedge_negative 3*x - 5*y + {} (w62)", a, b, c, rest));
  };
  const std::int64_t linear = 3 * 100 + 5 * 64;
  CHECK(error(1, 1, 1, limit - 1 - linear - 10'000 - 6'400 - 4'096).empty());
  CHECK(contains(error(1, 1, 1, limit - linear - 10'000 - 6'400 - 4'096), "t:3:1: squares: over 100x64 pixels"));
  CHECK(error(limit / 10'000 - 1, 0, 0, 1).empty());
  CHECK_FALSE(error(limit / 10'000 + 1, 0, 0, 1).empty());
  CHECK_FALSE(error(0, limit / 6'400 + 1, 0, 1).empty());
  CHECK_FALSE(error(0, 0, limit / 4'096 + 1, 1).empty());
  CHECK_FALSE(error(std::int64_t{1} << 61U, std::int64_t{1} << 61U, std::int64_t{1} << 61U, 1).empty());
}

TEST_CASE("squares have 1 to 62 bits and no shift and no field") {
  const auto refusal_of = [](const Instruction& instruction) { return refusal([&] { validate(instruction, 128); }); };
  CHECK(refusal_of(squares({1, 2, 3, 62, 0})).empty());
  CHECK(contains(refusal_of(squares({1, 2, 3, 63, 0})), "squares are 63 bits wide; use 1 to 62"));
  CHECK(contains(refusal_of(squares({1, 2, 3, 0, 0})), "0 bits wide"));
  CHECK(contains(refusal_of(squares({1, 2, 3, 20, 1})), "no shift"));
  CHECK_FALSE(refusal_of({Opcode::squares, {{{0, 1}}}, {1, 2, 3, 20, 0}, 0, {}}).empty());
}

TEST_CASE("wide fields are allowed only where F is loaded or added and for roots") {
  CHECK(error_of("load_linear [0+:61], x (w62)").empty());
  CHECK(error_of("linear_plus [0+:61], x (w62)").empty());
  CHECK(error_of("linear_minus [67+:61], x (w62)").empty());
  CHECK(error_of("root [0+:61]").empty());
  CHECK(error_of("root [0+:3]").empty());
  CHECK(contains(error_of("load_linear [0+:62], x (w62)"), "F has 62 bits and is combined with a field of 62"));
  CHECK(contains(error_of("load_linear [0+:63], x (w62)"), "63 bits wide; a field has 1 to 62 bits"));
  CHECK(contains(error_of("load_linear [68+:61], x (w62)"), "outside the 128 memory bits"));
  for (const char* other : {"keep_max [0+:33], x (w62)", "linear_ge [0+:33], x (w62)", "set_constant [0+:33], 1",
                            "copy [0+:33], [40+:33]", "bit_not [0+:33], [40+:33]"})
    CHECK(contains(error_of(other), "33 bits wide; a field has 1 to 32 bits"));
  CHECK(contains(error_of("root [0+:40]"), "40 bits wide; use an odd number of bits, at least 3"));
  CHECK(contains(error_of("root [0+:1]"), "1 bits wide; use an odd number"));
  CHECK(contains(error_of("root [0+:63]"), "63 bits wide; a field has 1 to 62 bits"));
}

TEST_CASE("squares take five bytes in the binary form and survive a round trip") {
  const Program program = parse(header + "squares 3*x*x - 2*x*y + 5*y*y (w35)\nload_linear [0+:34], 7*x (w35)\n", "t");
  const auto bytes = encode(program);
  CHECK(decode(bytes, "t") == program);
  // The opcode, with the mark of an unchanged origin, and 3, -2, 5 and 35 take one byte each.
  const Program without = parse(header + "load_linear [0+:34], 7*x (w35)\n", "t");
  CHECK(bytes.size() == encode(without).size() + 5);
}

}  // namespace
