#include <rapidcheck.h>

#include "hw/base/nearest.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/text.h"
#include "tests/support/test.h"
#include "tests/unit/isa/sample.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

using test::refusal;

const std::string array = ".array width=8 height=8 memory_bits=32\n";
const std::string header = array + ".field Z1 [0+:8] depth\n.primitive \"p\"\n.segment width=8 height=8\n";

std::string error_of(const std::string& text) {
  return refusal([&] { parse(text, "t"); });
}

/// Error of an instruction in line 5 of an otherwise valid Program.
std::string error_in_line_5(const std::string& line) { return error_of(header + line + "\nenable_all\n"); }

TEST_CASE("an unknown word is reported with its position and the nearest known one") {
  CHECK(error_in_line_5("  keep_mx Z1, x (w9)") == "t:5:3: unknown instruction 'keep_mx'; the nearest is 'keep_max'");
  CHECK(error_in_line_5("keep_max Z2, x (w9)") == "t:5:10: unknown field 'Z2'; the nearest is 'Z1'");
  CHECK(error_in_line_5("enable_all ; rendr p0") == "t:5:14: unknown purpose 'rendr'; the nearest is 'render'");
  CHECK(error_of(array + ".fild Z [0] depth") == "t:2:2: unknown directive 'fild'; the nearest is 'field'");
  CHECK(error_of(array + ".field Z [0] dpth") == "t:2:14: unknown field role 'dpth'; the nearest is 'depth'");
  CHECK(error_of(array + ".model file=\"a\" union=3") == "t:2:17: unknown key 'union'; the nearest is 'unions'");
  CHECK(error_of(array + ".segment width=8 height=8\nenable_load a") ==
        "t:3:13: unknown field 'a'; none is defined yet");
}

TEST_CASE("a syntax error is one line even if it quotes control characters") {
  CHECK(error_in_line_5("enable_load \"a\\x0ab\"") == "t:5:13: unknown field 'a\\nb'; the nearest is 'Z1'");
}

TEST_CASE("the nearest of long words is found quickly by their prefixes") {
  const std::string a(1'000'000, 'a');
  const std::string b(1'000'000, 'b');
  const std::vector<std::string_view> words{b, a};
  CHECK(nearest(a + "c", words) == a);
}

TEST_CASE("a syntax error in Program text is reported with its position") {
  CHECK(error_in_line_5("keep_max Z1 x (w9)").starts_with("t:5:13: expected a comma"));
  CHECK(error_in_line_5("keep_max Z1, 3*z (w9)").starts_with("t:5:16: expected x or y"));
  CHECK(error_in_line_5("keep_max Z1, 3*x").starts_with("t:5:17: expected the width of the linear expression"));
  CHECK(error_in_line_5("keep_max Z1, x + (w9)").starts_with("t:5:18: expected a term"));
  CHECK(error_in_line_5("keep_max Z1, x (w)").starts_with("t:5:18: expected a width"));
  CHECK(error_in_line_5("keep_max Z1, x (w9 >> )").starts_with("t:5:23: expected a number of fraction bits"));
  CHECK(error_in_line_5("keep_max Z1, x (w9").starts_with("t:5:19: expected )"));
  CHECK(error_in_line_5("copy").starts_with("t:5:5: expected a field"));
  CHECK(error_in_line_5("copy [x]").starts_with("t:5:7: expected the number of a bit"));
  CHECK(error_in_line_5("copy [1+:]").starts_with("t:5:10: expected a width"));
  CHECK(error_in_line_5("copy [1+2]").starts_with("t:5:8: expected ]"));
  CHECK(error_in_line_5("set_constant Z1, y").starts_with("t:5:18: expected a constant"));
  CHECK(error_in_line_5("set_constant Z1, 0xg").starts_with("t:5:20: expected hexadecimal"));
  CHECK(error_in_line_5("enable_all Z1").starts_with("t:5:12: unexpected text"));
  CHECK(error_in_line_5("enable_all ; ").starts_with("t:5:14: expected a purpose"));
  CHECK(error_in_line_5("enable_all ; render p0 against pq").starts_with("t:5:33: expected the index"));
  CHECK(error_in_line_5("~").starts_with("t:5:1: expected an instruction"));
  CHECK(error_of(array + ".primitive \"a").starts_with("t:2:14: the string does not end"));
  CHECK(error_of(array + ".primitive \"\\n\"").starts_with("t:2:14: unknown escape"));
  CHECK(error_of(array + ".primitive p").starts_with("t:2:12: expected a string"));
  CHECK(error_of(array + ".compile effects=[\"a\" 3]").starts_with("t:2:23: expected ]"));
  CHECK(error_of(array + ".model unions").starts_with("t:2:14: expected ="));
  CHECK(error_of(array + ".model unions=").starts_with("t:2:15: expected a number"));
}

TEST_CASE("a wrong or out-of-range value in Program text is reported with its position") {
  CHECK(error_of(array + ".model unions=\"1\"").starts_with("t:2:8: unions must be a number"));
  CHECK(error_of(array + ".model unions=-1").starts_with("t:2:8: unions must be a whole number"));
  CHECK(error_of(array + ".compile z_bits=4294967296")
            .starts_with("t:2:10: z_bits must be a whole number from 0 to 4294967295"));
  CHECK(error_of(array + ".model file=gear").starts_with("t:2:8: file must be a string"));
  CHECK(error_of(array + ".compile effects=\"a\"").starts_with("t:2:10: effects must be a list"));
  CHECK(error_of(array + ".depth perspective=1").starts_with("t:2:8: perspective must be true or false"));
  CHECK(error_of(array + ".depth near=1e999").starts_with("t:2:8: near must be a number in the range of doubles"));
  CHECK(error_of(array + ".depth near=nan").starts_with("t:2:1: depth runs from"));
  CHECK(error_of(array + ".model unions=1 unions=2").starts_with("t:2:17: unions is given twice"));
  CHECK(error_in_line_5("set_constant Z1, 18446744073709551616")
            .starts_with("t:5:18: 18446744073709551616 is out of range"));
  CHECK(error_in_line_5("edge_negative 9223372036854775808 (w9)").starts_with("t:5:15: coefficient"));
  CHECK(error_in_line_5("edge_negative x + 2*x (w9)").starts_with("t:5:19: two terms"));
  CHECK(error_in_line_5("enable_all ; render p4294967295").starts_with("t:5:22: 4294967295 is out of range"));
  CHECK(error_in_line_5("copy [70000], [1]").starts_with("t:5:7: 70000 is out of range"));
}

TEST_CASE("a key of another directive is reported with that directive's name") {
  CHECK(
      error_of(array + ".compile background=1").starts_with("t:2:10: background is a key of .frame, not of .compile"));
  CHECK(error_of(array + ".frame figures=[]").starts_with("t:2:8: figures is a key of .machine"));
}

TEST_CASE("a colour field must match the displayed colour declared before it") {
  const std::string field = ".field colour [8+:6] colour";
  CHECK(error_of(array + field)
            .starts_with(
                "t:2:1: field [8+:6] has the role colour, but the frame displays nothing; write .frame colour_base=8 "
                "colour_bits=6 before this field"));
  CHECK(error_of(array + ".frame colour_base=8 colour_bits=7\n" + field)
            .starts_with("t:3:1: field [8+:6] has the role colour, but the frame displays [8+:7]"));
  CHECK(error_of(array + ".frame colour_base=8 colour_bits=6\n" + field).empty());
  CHECK(
      error_of(array + ".frame colour_base=30 colour_bits=6").starts_with("t:2:1: the displayed field: field [30+:6]"));
}

TEST_CASE("rejects an extent whose rows are reversed or outside the picture") {
  CHECK(error_of(array + ".extent first=2 last=1").starts_with("t:2:1: the extent from row 2 to row 1"));
  CHECK(error_of(array + ".extent first=2 last=8").starts_with("t:2:1: the extent from row 2 to row 8"));
  CHECK(error_of(array + ".extent last=65536").starts_with("t:2:9: last must be a whole number from 0 to 65535"));
  CHECK(error_of(array + ".extent last=7").empty());
}

TEST_CASE("a validation error in Program text is reported with its position") {
  CHECK(error_in_line_5(" keep_max Z1, x (w8)").starts_with("t:5:2: keep_max: F has 8 bits"));
  CHECK(error_in_line_5("enable_all ; render p1").starts_with("t:5:1: the origin's primitive is p1"));
  CHECK(error_in_line_5("edge_negative 4611686018427387904 (w9)").starts_with("t:5:1: edge_negative: |A|"));
  CHECK(error_of(header + ".segment x=1 width=8 height=8").starts_with("t:5:1: the region of 8x8"));
  CHECK(error_of(array + ".field Z [31+:2] depth").starts_with("t:2:1: field [31+:2] ends outside"));
  CHECK(error_of(".array width=8 height=8 memory_bits=9999").starts_with("t:1:1: a pixel has 9999 memory bits"));
}

TEST_CASE("an error in a skip in Program text is reported with its position") {
  CHECK(error_in_line_5("skip_if_none 1").empty());
  CHECK(error_in_line_5("skip_if_none").starts_with("t:5:13: expected a number of instructions"));
  CHECK(error_in_line_5("skip_if_none Z1").starts_with("t:5:14: expected a number of instructions"));
  CHECK(error_in_line_5("  skip_if_none 0").starts_with("t:5:3: skip_if_none 0 skips nothing"));
  CHECK(error_in_line_5("enable_all\n  skip_if_none 2")
            .starts_with("t:6:3: skip_if_none 2 skips past the end of the segment"));
  CHECK(error_in_line_5("skip_if_none 18446744073709551615").starts_with("t:5:1: skip_if_none 18446744073709551615"));
  const std::string end = ".segment width=8 height=8\nenable_all\nenable_all";
  CHECK(error_in_line_5("skip_if_none 1\n" + end)
            .starts_with("t:5:1: skip_if_none 1 skips past the end of the segment, which has 0"));
}

TEST_CASE("preparation counts beyond the limit are rejected and so is their sum") {
  constexpr const char* most = "281474976710656";
  const std::string segment = ".segment width=8 height=8\n";
  CHECK(error_of(array + ".prepare boxes=281474976710657\n" + segment) ==
        std::string("t:2:1: boxes=281474976710657 exceeds the limit of a frame, ") + most + "; use a smaller model");
  CHECK_NOTHROW(parse(array + ".prepare boxes=" + most + "\n" + segment, "t"));
  CHECK(error_of(array + ".prepare boxes=" + most + "\n" + segment + ".prepare boxes=1\n") ==
        std::string("t: sum of all .prepare: boxes=281474976710657 exceeds the limit of a frame, ") + most +
            "; use a smaller model");
}

TEST_CASE("preparation and pruning directives are read if unique and before the segments") {
  const std::string segment = ".segment width=8 height=8\n";
  const isa::Program program =
      parse(array + ".prepare_model supports=7\n.pruning name=\"space\" tried=3\n" + segment, "t");
  CHECK(*program.model_preparation == isa::Preparation{.supports = 7});
  CHECK(program.facts->prunings == std::vector{isa::PruningFacts{.name = "space", .tried = 3}});
  CHECK(*program.preparation == isa::Preparation{});
  CHECK(error_of(array + ".prepare_model\n.prepare_model\n").starts_with("t:3:2: .prepare_model appears twice"));
  CHECK(error_of(array + segment + ".prepare_model\n").starts_with("t:3:2: .prepare_model comes after a .segment"));
  CHECK(error_of(array + ".prepare_model boxes=281474976710657\n").starts_with("t:2:1: boxes=281474976710657 exceeds"));
  CHECK(error_of(array + ".pruning tries=3\n").find("the nearest is 'tried'") != std::string::npos);
}

TEST_CASE("directives that are repeated or out of order are rejected with their position") {
  CHECK(error_of("").starts_with("t: there is no .array"));
  CHECK(error_of(".model unions=1\n" + array).starts_with("t:1:2: .model comes before .array"));
  CHECK(error_of(array + "enable_all").starts_with("t:2:1: the instruction is in no segment"));
  CHECK(error_of(header + ".field Q [9] stack").starts_with("t:5:2: .field comes after a .segment"));
  CHECK(error_of(array + array).starts_with("t:2:2: .array appears twice"));
  CHECK(error_of(array + ".field Q [9] stack\n.field Q [8] stack").starts_with("t:3:1: field \"Q\" is named twice"));
}

TEST_CASE("a corrupted text of a Program is a valid one or rejected in a single line") {
  std::ostringstream out;
  print(out, test::sample_program());
  const std::string sound = out.str();
  CHECK(rc::check("parse() returns a valid Program or an error", [&sound] {
    std::string text = sound;
    const auto changes = *rc::gen::inRange(1, 6);
    for (int i = 0; i < changes; ++i) {
      const auto place = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, text.size()));
      switch (*rc::gen::element(0, 1, 2)) {
        case 0: text[place] = *rc::gen::element('0', '9', '"', '\\', '[', '\n', ' ', 'x', '-', '(', ',', '\0'); break;
        case 1: text.erase(place, 3); break;
        default: text.insert(place, sound.substr(text.size() / 2, 4)); break;
      }
    }
    Program program;
    const std::string error = refusal([&] { program = parse(text, "t"); });
    RC_ASSERT(error.find('\n') == std::string::npos);
    if (error.empty()) validate(program);
  }));
}

TEST_CASE("the suggested name is the one with the fewest edits") {
  constexpr std::array<std::string_view, 3> names{"copy", "keep_max", "keep_min"};
  CHECK(nearest("kep_min", names) == "keep_min");
  CHECK(nearest("cpoy", names) == "copy");
  CHECK(nearest("", names) == "copy");
  CHECK(nearest("anything", {}).empty());
}

}  // namespace
