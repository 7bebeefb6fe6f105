#include "sim/session/options/option_list.h"

#include "sim/session/options/usage.h"
#include "tests/support/test.h"
#include "tests/unit/session/parsed.h"

using namespace csgsim;
using testing::Texts;
using testing::usage_error_of;

namespace {

/// A request with an option of each kind.
struct Request {
  std::string model;
  std::string colour = "red";
  std::string pixel;
  std::uint32_t bits = 20;
  std::optional<std::uint32_t> count;
  std::optional<std::uint64_t> seed;
  double edge = 1.0 / 256;
  std::optional<double> near;
  Texts sets;
  bool check = false;

  void add_to(session::OptionList& list) {
    list.option("MODEL", model, "The model").required();
    list.option("-b,--bits", bits, "Bits").between(4, 30);
    list.option("--colour,--color", colour, "A colour").one_of({"red", "green"});
    list.option("--count", count, "A count");
    list.option("--seed", seed, "A seed");
    list.option("--edge", edge, "A part of a pixel");
    list.option("--near", near, "A distance");
    list.option("--set", sets, "Figures");
    list.option("--pixel", pixel, "A pixel").excludes("--colour");
    list.flag("--check", check, "Check");
  }
};

using Parsed = testing::Parsed<Request>;

/// Returns the error message for a command line; empty if it is accepted.
std::string refusal_of(const Texts& words) {
  return usage_error_of([&] { const Parsed parsed(words); });
}

}  // namespace

TEST_CASE("a request has the values of its command line") {
  const Parsed all({"a.csg", "--bits", "30", "--color", "green", "--count", "0", "--seed", "18446744073709551615",
                    "--edge", "+0.5", "--near=-2.5e1", "--set", "a=1", "--set", "b=2", "--check"});
  CHECK(all.options.model == "a.csg");
  CHECK(all.options.bits == 30);
  CHECK(all.options.colour == "green");
  CHECK(all.options.count == 0U);
  CHECK(all.options.seed == 18446744073709551615ULL);
  CHECK(all.options.edge == 0.5);
  CHECK(all.options.near == -25.0);
  CHECK(all.options.sets == Texts{"a=1", "b=2"});
  CHECK(all.options.check);
}

TEST_CASE("options not given keep their defaults") {
  const Parsed few({"a.csg"});
  CHECK(few.options.bits == 20);
  CHECK(few.options.edge == 1.0 / 256);
  CHECK_FALSE(few.options.count.has_value());
  CHECK_FALSE(few.options.check);
  CHECK(few.list.given().empty());
}

TEST_CASE("each type of option rejects invalid values with a specific message") {
  struct Row {
    Texts words;
    std::string refusal;
  };
  for (const Row& row : std::vector<Row>{
           {{"--bits", "3"}, "--bits: '3' is not a whole number from 4 to 30"},
           {{"--bits", "31"}, "--bits: '31' is not a whole number from 4 to 30"},
           {{"--bits", "0x10"}, "--bits: '0x10' is not a whole number from 4 to 30"},
           {{"--bits", ""}, "--bits: '' is not a whole number from 4 to 30"},
           {{"--bits", "5", "--bits", "6"}, "--bits: given 2 times; give it once"},
           {{"--count", "-1"}, "--count: '-1' is not a whole number, 0 or more"},
           {{"--count", ""}, "--count: '' is not a whole number, 0 or more"},
           {{"--count", "1.5"}, "--count: '1.5' is not a whole number, 0 or more"},
           {{"--count", "4294967296"}, "--count: '4294967296' is more than 4294967295"},
           {{"--seed", "18446744073709551616"}, "--seed: '18446744073709551616' is more than 18446744073709551615"},
           {{"--edge", "x"}, "--edge: 'x' is not a number"},
           {{"--edge", "1 "}, "--edge: '1 ' is not a number"},
           {{"--near", ""}, "--near: '' is not a number"},
           {{"--colour", "blue"}, "--colour: there is no colour 'blue'; the colours are red, green"},
           {{"--check=maybe"}, "--check: 'maybe' is neither true nor false"},
           {{"--pixel", "1,1", "--colour", "red"}, "--colour excludes --pixel; leave one out"},
           {{"--count"}, "--count: needs a value"},
           {{"--colr", "red"}, "there is no option --colr; did you mean --colour? see csgsim asked --help"},
           {{"b.csg"}, "unexpected argument b.csg; see csgsim asked --help"},
       }) {
    Texts words = row.words;
    words.insert(words.begin(), "a.csg");
    CAPTURE(words);
    CHECK(refusal_of(words) == row.refusal);
  }
  CHECK(refusal_of({"--bits", "5"}) == "MODEL is required; name it, as in csgsim asked MODEL");
}

TEST_CASE("an option accepts the limits of its range") {
  for (const char* const bits : {"4", "30"}) CHECK(refusal_of({"a.csg", "--bits", bits}).empty());
  CHECK(refusal_of({"a.csg", "--count", "4294967295"}).empty());
}

TEST_CASE("rejects a zero byte in the text of an option or operand") {
  session::OptionList list("asked");
  Request request;
  request.add_to(list);
  const std::string text("red\0x", 5);
  CHECK(usage_error_of([&] { list.give("colour", text); }).find("zero byte") != std::string::npos);
  CHECK(usage_error_of([&] { list.give_operand(text); }).find("zero byte") != std::string::npos);
}

TEST_CASE("only an option that is a flag may lack a value") {
  session::OptionList list("asked");
  Request request;
  request.add_to(list);
  CHECK(usage_error_of([&] { list.give_flag("colour"); }) == "--colour: needs a value");
  list.give_flag("check");
  list.give_operand("a.csg");
  list.check_and_apply();
  CHECK(request.check);
}

TEST_CASE("a request's words parse to the same request again") {
  const Parsed first({"--near=-1", "--set", "a=1", "--check", "--bits", "7", "--", "-dash.csg"});
  const Texts written = first.list.words();
  CHECK(written == Texts{"asked", "--bits", "7", "--near=-1", "--set", "a=1", "--check", "--", "-dash.csg"});
  const Parsed again(Texts(written.begin() + 1, written.end()));
  CHECK(again.list.words() == written);
  CHECK(again.options.near == -1.0);
  const std::vector<std::string_view> but{"bits", "check"};
  CHECK(again.list.words(but) == Texts{"asked", "--near=-1", "--set", "a=1", "--", "-dash.csg"});
  CHECK(again.list.arguments().front() == "csgsim");
}

TEST_CASE("a flag given as false is not set") {
  const Parsed unset({"a.csg", "--check=false"});
  CHECK_FALSE(unset.options.check);
  CHECK(unset.list.words() == Texts{"asked", "a.csg"});
}

TEST_CASE("invalid values of a settings file are rejected with their place") {
  session::OptionList list("asked");
  Request request;
  request.add_to(list);
  list.give_operand("a.csg");
  session::Option& bits = *list.find("bits");
  bits.given = {"99"};
  bits.place = "x.toml:3:1";
  CHECK(testing::error_of([&] { list.check_and_apply(); }) ==
        "x.toml:3:1: --bits: '99' is not a whole number from 4 to 30");
  CHECK(list.place_of("--bits: too many") == "x.toml:3:1");
  CHECK(list.place_of("--bits-more: too many").empty());
  CHECK(list.place_of("--colour: no").empty());
}

TEST_CASE("default values of options are shown as they are written") {
  const Parsed few({"a.csg"});
  const auto usual = [&](std::string_view key) { return few.list.find(key)->usual; };
  CHECK(usual("bits") == "20");
  CHECK(usual("edge") == "0.00390625");
  CHECK(usual("colour") == "red");
  CHECK(usual("near").empty());
}

TEST_CASE("a removed option is unknown as if it had never been added") {
  session::OptionList list("asked");
  Request request;
  request.add_to(list);
  list.remove("--colour");
  list.remove("MODEL");
  CHECK(list.find("colour") == nullptr);
  list.give("bits", "5");
  list.check_and_apply();
  CHECK(request.bits == 5);
  CHECK_THROWS_AS(list.remove("--colour"), std::logic_error);
}
